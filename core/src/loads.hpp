// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The loads of a grasp file: wrenches, forces at points, torques and weights, summed exactly
/// to wrenches about the origin.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "intervals.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip::core_detail {

/// What loads are on.
struct LoadSpace {
  bool in_space;
  const Mechanism* mechanism = nullptr;  ///< unless it is one body

  /// How many numbers a load comes to.
  std::size_t components() const {
    return mechanism != nullptr ? mechanism->coordinates() : in_space ? 6 : 3;
  }
};

/// What an object gives as "wrench" or as "loads"; nothing if it has neither.
std::optional<WrenchBox> read_load(const JsonNode& object, const std::string& path,
                                   const LoadSpace& space, IntervalReader& read);

/// A case: its name, and its load with the common one.
struct ReadCase {
  std::string name;
  WrenchBox load;
};
/// The elements of "cases"; none if there is no such key.
std::vector<ReadCase> read_cases(const JsonNode& root, const WrenchBox& common,
                                 const LoadSpace& space, IntervalReader& read);

/// Where the weights of loads, also those of cases, pull at which body. Requires that all these
/// were read.
std::vector<std::pair<std::size_t, RationalRow>> weight_points(const JsonNode& root,
                                                               const Mechanism& mechanism);

/// Whether some component is no number.
bool is_uncertain(const WrenchBox& wrench);

}  // namespace stickslip::core_detail
