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

/// The load w, of which components may be intervals, "[-1, 1]".
std::string load_text(const WrenchBox& load, NumberText& text);

/// Which lengths are irrational, and what stands in their place; nothing for no contacts.
std::string enclosure_text(const std::vector<std::size_t>& contacts, unsigned bits,
                           bool proved);

/// A table of these numbers of a box and what ball of loads it has; nothing if there are none.
std::string uncertain_text(const GraspBox& box, const std::vector<UncertainNumber>& numbers,
                           NumberText& text);

/// "force^2 + (torque/2)^2 <= (1/10)^2", and about which point and on which body.
std::string ball_text(const LoadBall& ball, NumberText& text);

/// Spells the bound on motions of a box as --max-motion takes it: a length and an angle where
/// these say all.
std::string bound_text(const GraspBox& box);

/// A line, if motions are bounded: "Motions up to 1,0.1 are asked about."
std::string motions_text(const Question& question);

/// Which way a number may be rounded so that what is said of it stays true.
enum class Round { kDown, kUp };

/// Four digits of a number, or all of them.
std::string rounded_text(const Rational& number, Round round, bool all_digits);

/// The first rows of a table, its heading not counted.
std::string short_table(std::vector<std::vector<std::string>> rows);

}  // namespace stickslip
