// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Branch and bound over regions of motions, for any law. What doubles propose is confirmed
/// exactly.
///
/// **Method.** A region is refuted by the point of least norm of the wrenches that it allows
/// (Wolfe's method): if that is not 0, it is a virtual twist. Else the wrenches that add up to
/// 0 are a relaxed equilibrium, and the region is cut where that breaks a law with the most
/// energy.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "stickslip/equilibrium/proof.hpp"
#include "stickslip/equilibrium/search_end.hpp"
#include "stickslip/motion/tree_walk.hpp"
#include "stickslip/search/motion_region.hpp"
#include "stickslip/search/search_work.hpp"

namespace stickslip {

namespace search_detail {
class AllowedWrenches;
struct Wedge;
}  // namespace search_detail

/// Motion and forces of a region whose wrenches add up to 0, in the law's units.
struct Relaxation {
  Reals motion{};                   ///< d, h and l
  std::vector<double> normal{};     ///< a by contact
  std::vector<Double3> friction{};  ///< f by contact: as a slip has coordinates
  /// Pairs of generators that take part, those far apart and of large weight first.
  std::vector<std::pair<std::size_t, std::size_t>> pairs{};
};

/// A motion at which forces nearly balance the load, in the law's units: of a relaxation over
/// its height, or of Newton's method.
struct NearEquilibrium {
  Reals motion;                   ///< d
  std::vector<double> normal;     ///< a by contact
  std::vector<Double3> friction;  ///< f by contact: as a slip has coordinates
  std::vector<char> sticks;       ///< whether the slip is nearly 0, of contacts that rub
  double multiple = 0;            ///< l, of a relaxation
};

/// One search, or several that share a limit.
class TreeSearch {
 public:
  /// `pull` is that of list 2, or null. All must outlive this.
  TreeSearch(const Law& law, const PullRule* pull, std::size_t node_limit, SearchWork& work)
      : law_(law), pull_(pull), nodes_left_(node_limit), work_(work) {}

  /// \{ To be called with relaxed equilibria that may be near real ones; true ends the search.
  using Candidate = std::function<bool(const NearEquilibrium&)>;
  void on_candidate(Candidate candidate) { candidate_ = std::move(candidate); }
  /// \}

  /// \{ To be asked where doubles do not decide, as beside an equilibrium: for a leaf that
  /// refutes the region, or the contact to split. Then contacts alone are split, so that the
  /// search ends.
  using Exact = std::function<TreeNode(const MotionRegion&)>;
  void on_doubt(Exact exact) { exact_ = std::move(exact); }
  /// \}

  /// Appends a tree that refutes the region; false if none was found, and then `trees` has some
  /// nodes more.
  bool refute(const MotionRegion& region, Trees& trees);
  /// Of the last search.
  SearchEnd end() const { return end_; }

 private:
  using Branch = BranchOf<TreeNode, MotionRegion>;

  std::optional<Branch> examine(const MotionRegion& region, std::size_t depth);
  std::optional<Row> confirm(const MotionRegion& region,
                             const search_detail::AllowedWrenches& wrenches,
                             const Reals& twist);
  Branch exactly(const MotionRegion& region, const search_detail::AllowedWrenches& wrenches);
  std::optional<Branch> split(const MotionRegion& region,
                              const search_detail::AllowedWrenches& wrenches,
                              const Relaxation& found);
  std::optional<Branch> split_separation(const MotionRegion& region, const Relaxation& found,
                                         std::size_t contact) const;
  std::optional<Branch> split_slip(const MotionRegion& region, const Relaxation& found,
                                   std::size_t contact) const;
  std::optional<Branch> split_spatial_slip(const MotionRegion& region, const Relaxation& found,
                                           std::size_t contact) const;
  std::optional<Branch> split_corners(const MotionRegion& region, const Relaxation& found,
                                      const std::vector<Row>& planes,
                                      const std::vector<Row>& orders, bool is_slip) const;
  std::optional<Branch> split_short(const MotionRegion& region, const Relaxation& found,
                                    const std::vector<Row>& planes, bool always = false) const;
  std::optional<Branch> split_wedge(const MotionRegion& region, const Relaxation& found,
                                    const search_detail::Wedge& wedge) const;
  bool is_candidate(const MotionRegion& region, const Relaxation& found) const;
  bool escapes(const Relaxation& found, double energy) const;
  double height(const Relaxation& found) const;

  const Law& law_;
  const PullRule* pull_;
  std::size_t nodes_left_;
  SearchEnd end_ = SearchEnd::kNone;
  std::size_t nodes_ = 0;
  double least_gap_ = 1e-3;  ///< of relaxed equilibria that were tried, over the energy
  Candidate candidate_;
  Exact exact_;
  SearchWork& work_;
};

}  // namespace stickslip
