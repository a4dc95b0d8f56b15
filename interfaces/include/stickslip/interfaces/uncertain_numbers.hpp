// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The numbers of a box that are uncertain, under their names in a grasp file.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/number_text.hpp"

namespace stickslip {

/// A number of the box that is an interval, under its name in a grasp file.
struct UncertainNumber {
  std::string place;     ///< "contacts[0].friction"; of a normal in space "….normal.turn_u"
  Interval interval;     ///< its values
  std::size_t turn = 0;  ///< which turn of a normal it is, from 1; the interval is then [-E, E]

  /// Returns true if it is a turn.
  bool is_turn() const { return turn > 0; }
  /// Returns its name for people.
  std::string label() const { return place + (is_turn() ? ", slope" : ""); }
};

/// Returns all uncertain numbers, contact by contact, and then those of the wrench; a ball of
/// loads gives the ends of a box around it.
std::vector<UncertainNumber> uncertain_numbers(const GraspBox& box);

/// Returns the value of each uncertain number of a box, in their order, in one grasp of the
/// box.
std::vector<Rational> values_in(const GraspBox& box, const GraspBox& grasp);

/// A number in which the two grasps of a fragile box differ.
struct Difference {
  UncertainNumber number;  ///< the number
  Rational stable;         ///< its value in the stable one
  Rational unstable;       ///< its value in the unstable one
};

/// Returns the numbers in which two grasps of a box differ; those come first that differ most,
/// as parts of their intervals.
std::vector<Difference> differences(const GraspBox& box, const GraspBox& stable,
                                    const GraspBox& unstable);

/// Returns a list of places and two numbers.
Json differences_json(const std::vector<Difference>& differences);

/// Returns a number, or two.
Json interval_json(const Interval& interval);
/// Returns radius, length, and perhaps point and body.
Json ball_json(const LoadBall& ball);
/// Returns a list of places and intervals.
Json uncertain_json(const std::vector<UncertainNumber>& numbers);

/// Returns the components of a wrench, each a number or two.
Json wrench_json(const WrenchBox& wrench);

}  // namespace stickslip
