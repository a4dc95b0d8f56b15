// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts about every grasp in a box, with proofs that certificate/FORMAT.md, sections 6 and
/// 7, explain.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "stickslip/engine/proof.hpp"
#include "stickslip/engine/search_options.hpp"
#include "stickslip/engine/search_work.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// The answer about a box of grasps, and the work to find it.
struct BoxDecision {
  /// The verdict. Only in space or about several bodies it may state an exact equilibrium, a
  /// ShareWitness.
  Verdict verdict;
  SearchWork work{};             ///< the work to find it
  unsigned bits = kDefaultBits;  ///< the precision of enclosed lengths, in bits
  /// A proof that no grasp has an equilibrium near by: with a motion within
  /// natural_bound(box, kFarMotion), 1000 times what the load would press. There is one only if
  /// the question has no bound of motions and is undecided.
  std::optional<Unstable> within{};
};

/// Decides whether every grasp in the box is stable, none is, or some are. Deterministic.
/// Returns Undecided when neither a proof nor two grasps with opposite verdicts were found
/// within the limits. If all grasps inside are stable and one on the border only just is, for
/// instance, there is neither.
BoxDecision decide_box(const GraspBox& box, NormalLaw law, const SearchOptions& options = {});

/// Returns the loads of a box. For a ball of loads it returns a box around all of them, the
/// smallest up to rounding outwards.
WrenchBox loads_of(const GraspBox& box);

/// Returns a proof that one exact grasp is stable, without stating an equilibrium: the
/// topological degree of a map shows that there is one in a parallelepiped of motions. Returns
/// nothing if no such proof was found, which says nothing about the verdict.
std::optional<BoxDecision> prove_stable_by_degree(const Problem& problem);

}  // namespace stickslip
