// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The numbers of a box as text for people.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "stickslip/engine/question.hpp"
#include "stickslip/interfaces/uncertain_numbers.hpp"

namespace stickslip {

/// Returns the load w, whose components may be intervals, "[-1, 1]".
std::string load_text(const WrenchBox& load, NumberText& text);

/// Returns which lengths are irrational, and what stands in their place; nothing for no
/// contacts.
std::string enclosure_text(const std::vector<std::size_t>& contacts, unsigned bits,
                           bool proved);

/// Returns a table of these numbers of a box, and the ball of loads that it has; nothing if
/// there are none.
std::string uncertain_text(const GraspBox& box, const std::vector<UncertainNumber>& numbers,
                           NumberText& text);

/// Returns "force^2 + (torque/2)^2 <= (1/10)^2", with the point and the body that it is about.
std::string ball_text(const LoadBall& ball, NumberText& text);

/// Spells the bound on motions of a box as --max-motion takes it: a length and an angle if
/// these say all.
std::string bound_text(const GraspBox& box);

/// Returns a line if motions are bounded: "Motions up to 1,0.1 are asked about."
std::string motions_text(const Question& question);

/// The direction in which a number may be rounded so that the statement about it stays true.
enum class Round { kDown, kUp };

/// Returns four digits of a number, or all of them.
std::string rounded_text(const Rational& number, Round round, bool all_digits);

/// Returns the first rows of a table; its heading is not counted.
std::string short_table(std::vector<std::vector<std::string>> rows);

}  // namespace stickslip
