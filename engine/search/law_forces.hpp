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
class Foresight;
struct Wedge;

/// A wrench that a region allows at one of its generators, with its forces by contact. If
/// `against` is set, it is a constraint direction that a twist has to be against, not the
/// wrench of a motion: a direction of loads, or what list 2 excludes at a generator.
struct AllowedWrench {
  double work = 0;            ///< the work on the twist that was asked about
  Reals wrench{};             ///< the sum of the load and all forces, as twists may see it
  Reals whole{};              ///< the same sum, unscaled, if twists may not see all of it
  std::size_t generator = 0;  ///< its index in the region; if there is none, how many there are
  bool against = false;       ///< a constraint direction; no motion goes with it
  std::vector<double> normal{};     ///< a by contact
  std::vector<Double3> friction{};  ///< f by contact
};

}  // namespace search_detail

/// The motion and forces of a region whose wrenches add up to 0, in the law's units.
struct Relaxation {
  Reals motion{};                   ///< d, h and l
  std::vector<double> normal{};     ///< a by contact
  std::vector<Double3> friction{};  ///< f by contact, with as many coordinates as a slip
  /// The pairs of generators that take part; those far apart and of large weight come first.
  std::vector<std::pair<std::size_t, std::size_t>> pairs{};

  /// \{ The breaches of laws by contact, the widest first.
  std::vector<std::pair<double, std::size_t>> separations{};
  std::vector<std::pair<double, std::size_t>> slips{};
  /// \}
  double energy = 0;  ///< the energy of the springs
  double gap = 0;     ///< the widest breach over the energy
};

/// The forces of one law.
class LawForces {
 public:
  using Region = MotionRegion;                ///< a node's region
  using Relaxed = Relaxation;                 ///< a relaxed equilibrium of a region
  using Candidate = NearEquilibrium;          ///< a relaxed equilibrium to try
  using Branch = BranchOf<TreeNode, Region>;  ///< a node with its children's regions
  /// The result of the search for a twist on a region.
  using Found = NearestWrench<Reals, search_detail::AllowedWrench>;

  /// `pull` is the rule of list 2, or null. All must outlive this.
  LawForces(const Law& law, const PullRule* pull, SearchWork& work);
  ~LawForces();
  LawForces(LawForces&& other) noexcept;  ///< only before a region is entered
  LawForces& operator=(LawForces&&) = delete;

  /// \{ The functions that TreeSearch asks for.
  std::size_t motions() const { return law_.motions; }
  std::size_t deepest() const;
  bool enter(const MotionRegion& region, std::size_t depth);
  Found nearest(bool again);
  bool may_try_again() const { return separated_; }
  std::optional<Row> confirm(const Reals& twist);
  Relaxation relaxed(const Found& found) const;
  bool escapes(const Relaxation& found);
  std::optional<NearEquilibrium> candidate(const Relaxation& found) const;
  std::optional<Branch> split(const Relaxation& found);
  std::optional<Branch> split_anywhere(const Relaxation& found) const;
  Branch branch(const TreeNode& node);
  void keep_to_contacts() { only_contacts_ = true; }
  /// \}
  /// Makes a search end once it meets many far motions. What rounding decides there may take
  /// longer than all else.
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
  std::optional<Branch> best_split(const Relaxation& found);
  Found nearest_of(const search_detail::AllowedWrenches& wrenches, bool again) const;
  std::optional<Row> in_few_bits(const Reals& twist);
  double height(const Relaxation& found) const;

  const Law& law_;
  const PullRule* pull_;
  SearchWork& work_;
  bool is_far(const Relaxation& found) const;

  bool only_contacts_ = false;
  bool keeps_near_ = false;
  std::size_t far_ = 0;                   ///< how many relaxed equilibria were far
  bool separated_ = false;                ///< a twist was found last
  const MotionRegion* region_ = nullptr;  ///< the region entered last
  std::unique_ptr<search_detail::AllowedWrenches> wrenches_;  ///< the region's wrenches
  std::unique_ptr<search_detail::Foresight> foresight_;       ///< of nodes to be entered
  std::optional<Found> foreseen_;  ///< what was found on the region before it was entered
};

/// A search for trees with the forces of one law.
class LawSearch : public TreeSearch<LawForces> {
 public:
  /// Takes the arguments of LawForces, and the limit of nodes of the search.
  LawSearch(const Law& law, const PullRule* pull, std::size_t node_limit, SearchWork& work)
      : TreeSearch(LawForces(law, pull, work), node_limit) {}
};

}  // namespace stickslip
