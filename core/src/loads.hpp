// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The loads of a grasp file: wrenches, forces at points, torques and weights, summed exactly
/// to wrenches about the origin.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "intervals.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip::core_detail {

/// Components of a wrench: forces and torques, where a point has `n` coordinates.
template <std::size_t n>
using LoadBox = std::array<Interval, n == 2 ? 3 : 6>;

/// What an object gives as "wrench" or as "loads"; nothing if it has neither. n = 2 in the
/// plane, 3 in space, as for the rest.
template <std::size_t n>
std::optional<LoadBox<n>> read_load(const JsonNode& object, const std::string& path,
                                    IntervalReader& read);

/// A case: its name, and its load with the common one.
template <std::size_t n>
struct ReadCase {
  std::string name;
  LoadBox<n> load;
};
/// The elements of "cases"; none if there is no such key.
template <std::size_t n>
std::vector<ReadCase<n>> read_cases(const JsonNode& root, const LoadBox<n>& common,
                                    IntervalReader& read);

extern template std::optional<LoadBox<2>> read_load<2>(const JsonNode&, const std::string&,
                                                       IntervalReader&);
extern template std::optional<LoadBox<3>> read_load<3>(const JsonNode&, const std::string&,
                                                       IntervalReader&);
extern template std::vector<ReadCase<2>> read_cases<2>(const JsonNode&, const LoadBox<2>&,
                                                       IntervalReader&);
extern template std::vector<ReadCase<3>> read_cases<3>(const JsonNode&, const LoadBox<3>&,
                                                       IntervalReader&);

/// Whether some component is no number.
bool is_uncertain(const WrenchBox& wrench);

}  // namespace stickslip::core_detail
