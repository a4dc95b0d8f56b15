// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the branch and bound does with one region in doubles: for grasps, and for the walls of
/// proofs by degree.
#pragma once

#include <functional>
#include <optional>

#include "region_forces.hpp"
#include "stickslip/motion/tree_walk.hpp"
#include "stickslip/planar/branch_and_bound.hpp"
#include "stickslip/planar/double_model.hpp"
#include "twist_search.hpp"

namespace stickslip::planar_detail {

/// Looks at one region after another.
class NodeSearch {
 public:
  using Step = BranchOf<TreeNode, Region>;

  /// Leaves have `leaf-direction` if there is a pull. All must outlive this; `model` is
  /// that of the problem.
  NodeSearch(const Problem& problem, const DoubleModel& model, const PullRule* pull,
             ConeWork& work)
      : problem_(problem), work_(work), forces_(problem, model), search_(model, pull) {}

  /// A relaxed equilibrium, and whether a contact of it breaks its law. (`precisely`: contacts
  /// one by one, no groups; `is_last`: nothing more precise comes.)
  struct Relaxed {
    const SearchResult& found;
    bool is_broken;
    bool precisely;
    bool is_last;
  };
  /// A leaf or a split; nothing where doubles tell neither, or if `ends` said to end at a
  /// relaxed equilibrium. `exactly`: twists that doubles do not confirm are tried exactly.
  std::optional<Step> examine(const Region& region, std::size_t depth, bool exactly,
                              const std::function<bool(const Relaxed&)>& ends);
  /// Where a contact breaks its law.
  Step split_at(const Region& region, const ContactSplit& split);

  /// What examine() uses.
  /// \{ That of the region read last.
  RegionForces& forces() { return forces_; }
  TwistSearch& search() { return search_; }
  /// \}

 private:
  const Problem& problem_;
  ConeWork& work_;
  RegionForces forces_;
  TwistSearch search_;
};

/// Appends to `trees` one that refutes the region, such as a wall; false if none is found of at
/// most `node_limit` nodes, and then what was appended is no tree. As NodeSearch.
bool append_wall(const Problem& family, const DoubleModel& model, Region wall,
                 const PullRule* pull, std::size_t node_limit, Trees& trees, ConeWork& work);

}  // namespace stickslip::planar_detail
