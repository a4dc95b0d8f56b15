// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Trees that refute walls of proofs by degree, in the plane, for thousands of contacts in
/// groups.
#pragma once

#include <memory>

#include "region.hpp"
#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/engine/newton_equilibria.hpp"

namespace stickslip {

struct DoubleModel;
class PullRule;

/// Refutes walls for one grasp, or for the members of a family.
class CrowdWalls {
 public:
  /// The problem must outlive it.
  explicit CrowdWalls(const Problem& problem);
  ~CrowdWalls();
  CrowdWalls(const CrowdWalls&) = delete;
  CrowdWalls& operator=(const CrowdWalls&) = delete;

  const Problem& problem() const { return problem_; }   ///< the problem in question
  const DoubleModel& model() const { return *model_; }  ///< the problem in doubles
  /// Returns equilibria around which there may be walls, as newton_equilibria() does; for one
  /// grasp.
  std::vector<NearEquilibrium> newton_equilibria(std::size_t starts, double length) const;
  /// Returns whether every contact is closed on all of a wall.
  bool all_are_closed(const Region& wall) const;
  /// Appends to `trees` one that refutes the wall, with `leaf-direction` if there is a pull.
  /// Returns false if none of at most `node_limit` nodes is found; then what was appended is no
  /// tree.
  bool refute(Region wall, const PullRule* pull, std::size_t node_limit, Trees& trees);
  /// Returns the work of all trees.
  const BranchWork& work() const { return work_; }

 private:
  const Problem& problem_;
  std::unique_ptr<const DoubleModel> model_;
  BranchWork work_;
};

}  // namespace stickslip
