// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Trees that refute walls of proofs by degree, in the plane and by groups of contacts: where
/// there are thousands of them.
#pragma once

#include <memory>

#include "region.hpp"
#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/engine/near_equilibria.hpp"

namespace stickslip {

struct DoubleModel;
class PullRule;

/// Of one grasp, or of the members of a family.
class CrowdWalls {
 public:
  /// The problem must outlive it.
  explicit CrowdWalls(const Problem& problem);
  ~CrowdWalls();
  CrowdWalls(const CrowdWalls&) = delete;
  CrowdWalls& operator=(const CrowdWalls&) = delete;

  const Problem& problem() const { return problem_; }   ///< what it is about
  const DoubleModel& model() const { return *model_; }  ///< of it
  /// Around which there may be walls: as near_equilibria(). Of one grasp.
  std::vector<NearEquilibrium> near_equilibria(std::size_t starts, double length) const;
  /// Whether every contact is closed on all of a wall.
  bool all_are_closed(const Region& wall) const;
  /// Appends to `trees` one that refutes the wall, with `leaf-direction` if there is a
  /// pull; false if none is found of at most `node_limit` nodes, and then what was
  /// appended is no tree.
  bool refute(Region wall, const PullRule* pull, std::size_t node_limit, Trees& trees);
  /// Of all trees.
  const ConeWork& work() const { return work_; }

 private:
  const Problem& problem_;
  std::unique_ptr<const DoubleModel> model_;
  ConeWork work_;
};

}  // namespace stickslip
