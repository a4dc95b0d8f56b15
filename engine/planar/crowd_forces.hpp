// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The forces of one grasp in the plane, with contacts in groups, for a tree search
/// (engine/search/tree_search.hpp).
#pragma once

#include <cstdint>
#include <optional>

#include "double_model.hpp"
#include "engine/motion/tree_walk.hpp"
#include "engine/search/tree_search.hpp"
#include "region_forces.hpp"
#include "stickslip/engine/branch_and_bound.hpp"
#include "twist_search.hpp"

namespace stickslip::planar_detail {

/// A relaxed equilibrium of a region, and the law that it breaks.
struct CrowdRelaxation {
  SearchResult found;
  std::optional<ContactSplit> broken;  ///< the split at the widest gap
  double gap;  ///< its size; if no law is broken 0, or 1 if another look may be more precise
};

/// The forces of one grasp, or of the members of a family.
class CrowdForces {
 public:
  using Region = stickslip::Region;
  using Relaxed = CrowdRelaxation;
  using Candidate = CrowdRelaxation;
  using Branch = BranchOf<TreeNode, Region>;

  /// Leaves have `leaf-direction` if there is a pull. `exactly` has twists that doubles do not
  /// confirm tried exactly. All must outlive this; `model` is that of the problem.
  CrowdForces(const Problem& problem, const DoubleModel& model, const PullRule* pull,
              bool exactly, BranchWork& work)
      : problem_(problem),
        exactly_(exactly),
        work_(work),
        forces_(problem, model),
        search_(model, pull) {}

  /// \{ The functions that TreeSearch asks for.
  std::size_t motions() const { return 3; }
  std::size_t deepest() const { return SIZE_MAX; }
  bool enter(const Region& region, std::size_t depth);
  SearchResult nearest(bool again);
  bool may_try_again() const { return !is_last_; }
  std::optional<Row> confirm(const Double3& twist);
  CrowdRelaxation relaxed(const SearchResult& found) const;
  bool escapes(const CrowdRelaxation& /*relaxed*/) const { return false; }
  std::optional<CrowdRelaxation> candidate(const CrowdRelaxation& relaxed) const {
    return relaxed;
  }
  std::optional<Branch> split(const CrowdRelaxation& relaxed);
  std::optional<Branch> split_anywhere(const CrowdRelaxation& /*relaxed*/) const {
    return std::nullopt;
  }
  Branch branch(const TreeNode& node);
  void keep_to_contacts() {}
  /// \}

  /// Returns a relaxed equilibrium of a region by itself, or nothing if there is none.
  std::optional<SearchResult> relaxation(const Region& region);
  /// Calls `set(contact, share)` for each contact that the region leaves open and for which
  /// `wanted(contact)` is true; the share is its friction over the most that it can have.
  template <class Wanted, class Set>
  void for_each_share(const SearchResult& found, const Wanted& wanted, const Set& set) const {
    for (const UndecidedGroup& u : forces_.undecided()) {
      forces_.for_each_contact(u, [&](std::uint32_t contact) {
        if (!wanted(contact)) return;
        const RelaxedForce force = search_.force(contact, u.freedom, found);
        if (force.normal > 0) set(contact, force.tangential / force.normal);
      });
    }
  }

 private:
  const Problem& problem_;
  bool exactly_;
  BranchWork& work_;
  const Region* region_ = nullptr;  ///< the region entered last
  bool is_last_ = false;            ///< no look at it is more precise than the last
  RegionForces forces_;             ///< the contacts on it
  TwistSearch search_;
};

}  // namespace stickslip::planar_detail
