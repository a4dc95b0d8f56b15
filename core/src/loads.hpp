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

/// What an object gives as "wrench" or as "loads"; nothing if it has neither.
std::optional<WrenchBox> read_load(const JsonNode& object, const std::string& path,
                                   bool in_space, IntervalReader& read);

/// A case: its name, and its load with the common one.
struct ReadCase {
  std::string name;
  WrenchBox load;
};
/// The elements of "cases"; none if there is no such key.
std::vector<ReadCase> read_cases(const JsonNode& root, const WrenchBox& common,
                                 IntervalReader& read);

/// Whether some component is no number.
bool is_uncertain(const WrenchBox& wrench);

}  // namespace stickslip::core_detail
