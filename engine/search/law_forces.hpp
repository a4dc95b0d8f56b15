// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The forces of any law, contact by contact, for a tree search (tree_search.hpp).
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/motion/nearest_wrench.hpp"
#include "stickslip/engine/motion_region.hpp"
#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/search_work.hpp"
#include "tree_search.hpp"

namespace stickslip {

namespace search_detail {

class AllowedWrenches;
struct Wedge;

/// A wrench that a region allows at one of its generators, and its forces by contact; or one
/// that a twist has to be against and no motion goes with: a direction of loads, or what list 2
/// excludes at a generator.
struct AllowedWrench {
  double work = 0;                  ///< on the twist that was asked about
  Reals wrench{};                   ///< of the load and all forces, as twists may see it
  Reals whole{};                    ///< all of it, unscaled, if that is not all
  std::size_t generator = 0;        ///< of the region; if none, how many it has
  bool against = false;             ///< no motion goes with it
  std::vector<double> normal{};     ///< a by contact
  std::vector<Double3> friction{};  ///< f by contact
};

}  // namespace search_detail

/// Motion and forces of a region whose wrenches add up to 0, in the law's units.
struct Relaxation {
  Reals motion{};                   ///< d, h and l
  std::vector<double> normal{};     ///< a by contact
  std::vector<Double3> friction{};  ///< f by contact: as a slip has coordinates
  /// Pairs of generators that take part, those far apart and of large weight first.
  std::vector<std::pair<std::size_t, std::size_t>> pairs{};

  /// \{ By how much laws are broken, the widest first.
  std::vector<std::pair<double, std::size_t>> separations{};
  std::vector<std::pair<double, std::size_t>> slips{};
  /// \}
  double energy = 0;  ///< of the springs
  double gap = 0;     ///< the widest breach over it
};

/// Of one law.
class LawForces {
 public:
  using Region = MotionRegion;                ///< of a tree
  using Relaxed = Relaxation;                 ///< that a region allows
  using Candidate = NearEquilibrium;          ///< of a relaxation
  using Branch = BranchOf<TreeNode, Region>;  ///< as of TreeSearch
  /// What is found of a region.
  using Found = NearestWrench<Reals, search_detail::AllowedWrench>;

  /// `pull` is that of list 2, or null. All must outlive this.
  LawForces(const Law& law, const PullRule* pull, SearchWork& work);
  ~LawForces();
  LawForces(LawForces&& other) noexcept;  ///< before a region was entered
  LawForces& operator=(LawForces&&) = delete;

  /// \{ As TreeSearch asks.
  std::size_t motions() const { return law_.motions; }
  std::size_t deepest() const;
  bool enter(const MotionRegion& region, std::size_t depth);
  Found nearest(bool again);
  bool may_try_again() const { return separated_; }
  std::optional<Row> confirm(const Reals& twist);
  Relaxation relaxed(const Found& found) const;
  bool escapes(const Relaxation& found);
  std::optional<NearEquilibrium> candidate(const Relaxation& found) const;
  std::optional<Branch> split(const Relaxation& found) const;
  std::optional<Branch> split_anywhere(const Relaxation& found) const;
  Branch branch(const TreeNode& node);
  void keep_to_contacts() { only_contacts_ = true; }
  /// \}
  /// From now on a search ends that meets many far motions: what rounding decides there may
  /// take longer than all else.
  void keep_near() { keeps_near_ = true; }

 private:
  std::optional<Branch> split_separation(const Relaxation& found, std::size_t contact) const;
  std::optional<Branch> split_slip(const Relaxation& found, std::size_t contact) const;
  std::optional<Branch> split_spatial_slip(const Relaxation& found, std::size_t contact) const;
  std::optional<Branch> split_corners(const Relaxation& found, const std::vector<Row>& planes,
                                      const std::vector<Row>& orders, bool is_slip) const;
  std::optional<Branch> split_short(const Relaxation& found, const std::vector<Row>& planes,
                                    bool always = false) const;
  std::optional<Branch> split_wedge(const Relaxation& found,
                                    const search_detail::Wedge& wedge) const;
  std::optional<Row> in_few_bits(const Reals& twist);
  double height(const Relaxation& found) const;

  const Law& law_;
  const PullRule* pull_;
  SearchWork& work_;
  bool is_far(const Relaxation& found) const;

  bool only_contacts_ = false;
  bool keeps_near_ = false;
  std::size_t far_ = 0;                                       ///< relaxed equilibria that were
  bool separated_ = false;                                    ///< what was found last
  const MotionRegion* region_ = nullptr;                      ///< the one entered last
  std::unique_ptr<search_detail::AllowedWrenches> wrenches_;  ///< of the region
};

/// A search with these.
class LawSearch : public TreeSearch<LawForces> {
 public:
  /// As LawForces.
  LawSearch(const Law& law, const PullRule* pull, std::size_t node_limit, SearchWork& work)
      : TreeSearch(LawForces(law, pull, work), node_limit) {}
};

}  // namespace stickslip
