// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads the intervals of a grasp file: {"min": A, "max": B}.
#pragma once

#include <string>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip::core_detail {

/// Reads numbers that may be intervals, and remembers where the first interval was.
class IntervalReader {
 public:
  explicit IntervalReader(std::string& first) : first_(first) {}

  /// Returns a number, or an interval whose ends are in order.
  Interval number(const JsonNode& node, const std::string& path);
  /// Returns `length` of them; `form` describes them, "an array of two numbers [x, y]".
  std::vector<Interval> numbers(const JsonNode& node, const std::string& path,
                                std::size_t length, const char* form);
  /// Notes that something at this place, which is no number, stands for an interval.
  void note(const std::string& path);

 private:
  std::string& first_;
};

}  // namespace stickslip::core_detail
