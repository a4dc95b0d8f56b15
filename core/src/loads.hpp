// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads the loads of a grasp file: wrenches, forces at points, torques and weights, summed
/// exactly to wrenches about the origin.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "intervals.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip::core_detail {

/// The body or bodies that loads act on.
struct LoadSpace {
  bool in_space;
  /// The mechanism of several bodies; null if there is one body.
  const Mechanism* mechanism = nullptr;
  /// The acceleration that the file gives as "gravity"; empty if it gives none.
  RationalRow gravity{};

  /// Returns how many numbers a load comes to.
  std::size_t components() const {
    return mechanism != nullptr ? mechanism->coordinates() : in_space ? 6 : 3;
  }
};

/// Returns "gravity" of a file, [x, y] or [x, y, z]; empty if it is not there.
RationalRow read_gravity(const JsonNode& root, bool in_space);

/// Returns the acceleration by which masses of these loads became forces; empty if no load, of
/// the file or of its cases, is a mass. Requires that all these loads were read.
RationalRow gravity_of_masses(const JsonNode& root, const LoadSpace& space);

/// Returns the load that an object gives as "wrench" or as "loads"; nothing if it has neither.
std::optional<WrenchBox> read_load(const JsonNode& object, const std::string& path,
                                   const LoadSpace& space, IntervalReader& read);

/// A case: its name, and its load together with the common one.
struct ReadCase {
  std::string name;
  WrenchBox load;
};
/// Returns the elements of "cases"; none if there is no such key.
std::vector<ReadCase> read_cases(const JsonNode& root, const WrenchBox& common,
                                 const LoadSpace& space, IntervalReader& read);

/// Returns the points at which weights and masses pull, in the common loads and in those of cases, each
/// with the index of its body. Requires that all these loads were read.
std::vector<std::pair<std::size_t, RationalRow>> weight_points(const JsonNode& root,
                                                               const Mechanism& mechanism);

/// Returns whether some component is an interval and not one number.
bool is_uncertain(const WrenchBox& wrench);

}  // namespace stickslip::core_detail
