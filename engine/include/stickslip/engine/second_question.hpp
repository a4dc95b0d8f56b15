// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The question that is answered beside one whose answer only rounding of the data decides.
#pragma once

#include <optional>

#include "stickslip/engine/question.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// Returns the second question to a question with this verdict, or nothing if the verdict says
/// all that matters. It has
///
/// - motions bounded by natural_bound(), if the verdict is undecided (about a box, for far
///   motions), or stable by motions beyond that; or
/// - the nearest load that no free motion sees, if the grasp is unstable and that load differs
///   from the one asked about by a part of less than 1e-12 of it, such as a torque of 1e-17
///   about the line through two fingers.
std::optional<Question> second_question(const Question& question, const Verdict& verdict);

/// Returns the direction of a margin without the part that no contact opposes, if that is less
/// than 1e-12 of it; else nothing.
std::optional<RationalRow> opposed_direction(const Question& question);

/// Returns by how much the loads of two questions differ: the square of the length of the
/// difference of forces, and of torques over a typical length of the grasp.
Rational squared_distance(const Question& a, const Question& b);

}  // namespace stickslip
