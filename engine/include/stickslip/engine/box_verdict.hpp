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

/// The answer about a box of grasps, and what it took.
struct BoxDecision {
  Verdict verdict;               ///< of exact motions only in space
  SearchWork work{};             ///< to find it
  unsigned bits = kDefaultBits;  ///< of the proof
  /// A proof that with natural_bound(box, kFarMotion) none of the grasps is stable; only if the
  /// question has no bound of motions, and is undecided.
  std::optional<Unstable> within{};
};

/// Whether every grasp in the box is stable, none is, or some are. Deterministic. Undecided
/// when no proof and no pair of grasps was found within the limits: the verdicts of a box with
/// a threshold on its border, for instance, have neither.
BoxDecision decide_box(const GraspBox& box, NormalLaw law, const SearchOptions& options = {});

/// The loads of a box; of a ball of loads the ends of a box around it.
WrenchBox loads_of(const GraspBox& box);

/// That one grasp in exact numbers is stable, as prove_by_degree() finds: Stable with
/// one part. Nothing if no proof was found, which says nothing about the verdict.
std::optional<BoxDecision> prove_stable_by_degree(const Problem& problem);

}  // namespace stickslip
