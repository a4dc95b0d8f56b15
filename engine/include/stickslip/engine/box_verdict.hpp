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
#include "stickslip/engine/search_work.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// The answer about a box of grasps, and the work to find it.
struct BoxDecision {
  /// The verdict. Only in space or about several bodies it may state an exact equilibrium, a
  /// ShareWitness.
  Verdict verdict;
  SearchWork work{};             ///< the work to find it
  unsigned bits = kDefaultBits;  ///< the bits of the proof's enclosures
  /// A proof that none of the grasps is stable within natural_bound(box, kFarMotion). There is
  /// one only if the question has no bound of motions and is undecided.
  std::optional<Unstable> within{};
};

/// Decides whether every grasp in the box is stable, none is, or some are. Deterministic.
/// Returns Undecided when neither a proof nor two grasps with opposite verdicts were found
/// within the limits. A box with a threshold on its border, for instance, has neither.
BoxDecision decide_box(const GraspBox& box, NormalLaw law, const SearchOptions& options = {});

/// Returns the loads of a box. For a ball of loads it returns the smallest box around them, up
/// to rounding.
WrenchBox loads_of(const GraspBox& box);

/// Returns a proof by degree, of one part, that one grasp in exact numbers is stable
/// (prove_by_degree()); nothing if no proof was found, which says nothing about the verdict.
std::optional<BoxDecision> prove_stable_by_degree(const Problem& problem);

}  // namespace stickslip
