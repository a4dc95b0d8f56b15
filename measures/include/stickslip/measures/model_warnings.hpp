// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Warnings that an exact answer may mislead, because the question leaves the model's validity
/// or rests on a value that nobody gave (docs/model.md). Warnings never change a verdict; their
/// thresholds are compared exactly.
///
/// - *Large motion*, of a stable verdict: the rotation is more than kLargestRotation, or a
///   contact point moves farther than the grasp is wide. The width is the diagonal of the box,
///   parallel to the axes, around the contacts; a width of 0, as that of one contact, is not
///   compared. The model is linear in the motion. Another equilibrium may move less.
/// - *Unbalanced preload*: at the motion d = 0, with normal forces P_i and no load, no friction
///   in the cones balances. This is decided exactly: doubles find a virtual twist or forces
///   that prove it, or else the linear program of the one motion d = 0 does
///   (region_program.hpp). The body then moves before any load is applied.
/// - *Lost preload*, of a stable verdict: some contact is preloaded, and no preloaded contact
///   keeps P_i / kLeastPartOfPreload as normal force.
/// - *Assumed stiffness*: with another stiffness of one contact for which the file gives none,
///   the verdict is the opposite. In grasps of at most kMostContactsToVary contacts, each such
///   contact in turn is tried with the smallest and the largest stiffness that the file gives
///   to others, with kStiffnessFactor and with its inverse. Doubles choose which of these are
///   decided; the decisions together take at most as many nodes as the verdict, plus
///   kNodesToVary. Silence proves nothing. A common factor of all stiffnesses changes no
///   verdict, since it divides the motion and leaves every v_i = P_i - k_i N_i.d and direction
///   of slip as it is: only ratios matter.
///
/// In space, and in the plane of what is decided as a box, a displacement is that of a point,
/// of three components, and a turn is the length of a rotation vector. Preloads are said not to
/// balance only if error bounds of doubles show it, so not on a border. An equilibrium that is
/// proved by degree counts by the motion that is near it. Several bodies have only the warnings
/// of contact_signs.hpp.
#pragma once

#include <vector>

#include "stickslip/engine/decide.hpp"
#include "stickslip/measures/margin.hpp"
#include "stickslip/measures/model_traps.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

/// Returns the warnings about an answer, about one grasp: none if numbers of one body are
/// uncertain. They take about as long as the verdict: O(m) rational operations, and the
/// decisions named above. With `only_of_motion` there are no such decisions; only large motions
/// and lost preloads are looked for.
std::vector<ModelWarning> model_warnings(const Answer& answer, bool only_of_motion = false);

/// \{ Return the warnings about a margin. They are about the equilibria at the ends of its
/// segments, or the exact ones at the ends of what is resisted: the first for which each sort
/// holds; and about the preloads that it begins with or, if these are 0, its growing preloads.
/// No stiffness is varied. O(m) rational operations for each segment.
std::vector<ModelWarning> model_warnings(const Question& question, const Margin& margin);
std::vector<ModelWarning> model_warnings(const Question& question, const SpatialMargin& margin);
/// \}

}  // namespace stickslip
