// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts about one grasp of so many coordinates that nothing is searched.
#pragma once

#include "stickslip/core/box.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// Returns whether a grasp has more coordinates than a law of contacts may have.
bool is_large(const GraspBox& grasp);

/// Decides one grasp of any number of coordinates. It is unstable if statics alone says that it
/// must move: a tree of one leaf. It is stable if an exact equilibrium is found, with modes
/// from Newton's method in doubles. Between the two it is undecided. Time grows about as that
/// of a sparse elimination; numbers of the equilibrium get as long as the bodies are many.
/// Requires that no number is uncertain.
BoxDecision decide_large(const GraspBox& grasp, NormalLaw law);

}  // namespace stickslip
