// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The numbers of a box, under their names in a grasp file, as answers show them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/core/spatial_grasp.hpp"

namespace stickslip {

/// A number of the box that is an interval, under its name in a grasp file.
struct UncertainNumber {
  std::string place;
  Interval interval;
  bool is_slope = false;  ///< of a normal: the interval is [-E, E]

  /// For people.
  std::string label() const { return place + (is_slope ? ", slope" : ""); }
};

std::vector<UncertainNumber> uncertain_numbers(const GraspBox& box);

std::vector<UncertainNumber> uncertain_numbers(const SpatialGrasp& box);

/// \{ The value of each uncertain number, in their order, in a grasp of the box.
std::vector<Rational> values_in(const GraspBox& box, const LoadedGrasp& loaded);
std::vector<Rational> values_in(const SpatialGrasp& box, const SpatialGrasp& grasp);
/// \}

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

/// The load w, of which components may be intervals, "[-1, 1]".
template <std::size_t n>
std::string load_text(const std::array<Interval, n>& load, NumberText& text) {
  std::string result;
  for (const Interval& w : load) {
    result += (result.empty() ? "(" : ", ") +
              (w.is_point() ? text(w.low) : "[" + text(w.low) + ", " + text(w.high) + "]");
  }
  return result + ")";
}

/// A table of them and a line below; nothing if there are none.
std::string uncertain_text(const std::vector<UncertainNumber>& numbers, NumberText& text);

/// The first rows of a table, its heading not counted.
std::string short_table(std::vector<std::vector<std::string>> rows);

}  // namespace stickslip
