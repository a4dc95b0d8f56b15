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
#include "stickslip/core/spatial_grasp.hpp"

namespace stickslip {

/// A number of the box that is an interval, under its name in a grasp file.
struct UncertainNumber {
  std::string place;      ///< "contacts[0].friction"
  Interval interval;      ///< its values
  bool is_slope = false;  ///< of a normal: the interval is [-E, E]

  /// For people.
  std::string label() const { return place + (is_slope ? ", slope" : ""); }
};

/// \{ All of them, contact by contact, and then those of the wrench.
std::vector<UncertainNumber> uncertain_numbers(const GraspBox& box);
std::vector<UncertainNumber> uncertain_numbers(const SpatialGrasp& box);
/// \}

/// \{ The value of each uncertain number, in their order, in a grasp of the box.
std::vector<Rational> values_in(const GraspBox& box, const LoadedGrasp& loaded);
std::vector<Rational> values_in(const SpatialGrasp& box, const SpatialGrasp& grasp);
/// \}

/// A number in which the two grasps of a fragile box differ.
struct Difference {
  UncertainNumber number;  ///< which
  Rational stable;         ///< its value in the stable one
  Rational unstable;       ///< its value in the unstable one
};

/// Of uncertain numbers and their values in both grasps: those that differ most, as parts of
/// their intervals, first.
std::vector<Difference> differences(std::vector<UncertainNumber> numbers,
                                    const std::vector<Rational>& stable,
                                    const std::vector<Rational>& unstable);

/// Of two grasps of a box.
template <class Box, class Grasp>
std::vector<Difference> differences(const Box& box, const Grasp& stable,
                                    const Grasp& unstable) {
  return differences(uncertain_numbers(box), values_in(box, stable), values_in(box, unstable));
}

/// A list of places and two numbers.
Json differences_json(const std::vector<Difference>& differences);

/// A number, or two.
Json interval_json(const Interval& interval);
/// A list of places and intervals.
Json uncertain_json(const std::vector<UncertainNumber>& numbers);

/// Components of a wrench, each a number or two.
template <std::size_t n>
Json wrench_json(const std::array<Interval, n>& wrench) {
  Json json = Json::array();
  for (const Interval& w : wrench) json.push_back(interval_json(w));
  return json;
}

}  // namespace stickslip
