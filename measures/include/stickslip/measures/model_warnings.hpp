// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Where an exact answer may mislead, because the question leaves the model's validity or rests
/// on a value that nobody gave (docs/model.md). Warnings never change a verdict; their
/// thresholds are compared exactly.
///
/// - *Large motion*, of a stable verdict: the rotation is more than kLargestRotation, or a
///   contact point moves farther than the grasp is wide: the diagonal of the box, parallel to
///   the axes, around the contacts (a width of 0, as that of one contact, is not compared). The
///   model is linear in the motion. Another equilibrium may move less.
/// - *Unbalanced preload*: at the motion d = 0, with normal forces P_i and no load, no friction
///   in the cones balances. Decided exactly: doubles find a virtual twist or forces that tell,
///   or else the system of the one motion d = 0 does (region_program.hpp). The body then moves
///   before any load is applied.
/// - *Lost preload*, of a stable verdict: some contact is preloaded, and none that is keeps
///   P_i / kLeastPartOfPreload as normal force.
/// - *Assumed stiffness*: with another stiffness of one contact for which the file gives none,
///   the verdict is the opposite. Tried are the smallest and the largest that the file gives to
///   others, kStiffnessFactor and its inverse, for each such contact in turn, in grasps of at
///   most kMostContactsToVary contacts. Doubles choose what is decided, and all of it together
///   takes as many nodes as the verdict, and kNodesToVary. Silence proves nothing. A common
///   factor of all stiffnesses changes no verdict, since it divides the motion and leaves every
///   v_i = P_i - k_i N_i.d and direction of slip as it is: only ratios matter.
#pragma once

#include <vector>

#include "stickslip/engine/question.hpp"
#include "stickslip/engine/verdict.hpp"
#include "stickslip/measures/margin.hpp"
#include "stickslip/measures/model_traps.hpp"

namespace stickslip {

/// Returns the warnings about a question, its problem and the verdict on it. They take about as
/// long as a verdict: O(m) rational operations, and the decisions named above, which are left
/// out with `only_of_motion`: then only large motions and lost preloads are looked for.
std::vector<ModelWarning> model_warnings(const Question& question, const Problem& problem,
                                         const Verdict& verdict, bool only_of_motion = false);

/// The same of a margin, about the equilibria at the ends of its segments, the first that each
/// sort is true of; and about the preloads that a family begins with or, if these are 0, with
/// which it grows. Stiffness is not varied. O(m) rational operations for each segment.
std::vector<ModelWarning> model_warnings(const Question& question, const Margin& margin);

}  // namespace stickslip
