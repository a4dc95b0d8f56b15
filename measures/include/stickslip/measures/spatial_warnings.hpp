// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Where an exact answer about a grasp in space, or about one in the plane that is decided as a
/// box, may mislead: the warnings of model_warnings.hpp, by the same rules (model_traps.hpp). A
/// displacement is that of a point, of three components, and a turn the length of a rotation
/// vector. Preloads are said not to balance where error bounds of doubles show it, and not on a
/// border. An equilibrium that is proved by degree counts by the motion that is near it.
/// Several bodies, in the plane and in space, have only what contact_signs.hpp says.
#pragma once

#include <vector>

#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/measures/model_traps.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

/// Returns the warnings about a question and the answer to it; about one body none if numbers
/// are uncertain. O(m) rational operations, and in grasps of at most kMostContactsToVary
/// contacts verdicts that take as many nodes as the answer took, and kNodesToVary. With
/// `only_of_motion` only large motions and lost preloads are looked for.
std::vector<ModelWarning> model_warnings(const Question& question, const BoxDecision& decision,
                                         bool only_of_motion = false);

/// The same of a margin, about the exact equilibria at the ends of what is resisted, the first
/// that each sort is true of; and about the preloads that it begins with or, if these are 0,
/// with which it grows. Stiffness is not varied.
std::vector<ModelWarning> model_warnings(const Question& question, const SpatialMargin& margin);

}  // namespace stickslip
