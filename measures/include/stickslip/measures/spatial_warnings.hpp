// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The warnings of model_warnings.hpp, by the same rules (model_traps.hpp), about a grasp in
/// space, or about one in the plane that is decided as a box. A displacement is that of a
/// point, of three components, and a turn is the length of a rotation vector. Preloads are said
/// not to balance only if error bounds of doubles show it, so not on a border. An equilibrium
/// that is proved by degree counts by the motion that is near it. Several bodies, in the plane
/// and in space, have only the warnings of contact_signs.hpp.
#pragma once

#include <vector>

#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/measures/model_traps.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

/// Returns the warnings about a question and the answer to it; none about one body if numbers
/// are uncertain. O(m) rational operations, and in grasps of at most kMostContactsToVary
/// contacts verdicts that take together as many nodes as the answer took, plus kNodesToVary.
/// With `only_of_motion` only large motions and lost preloads are looked for.
std::vector<ModelWarning> model_warnings(const Question& question, const BoxDecision& decision,
                                         bool only_of_motion = false);

/// Returns the warnings about a margin. They are about the exact equilibria at the ends of what
/// is resisted, the first for which each sort holds, and about the preloads that it begins with
/// or, if these are 0, its growing preloads. No stiffness is varied.
std::vector<ModelWarning> model_warnings(const Question& question, const SpatialMargin& margin);

}  // namespace stickslip
