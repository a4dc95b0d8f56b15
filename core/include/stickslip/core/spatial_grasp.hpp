// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a grasp file in space says (core/box.hpp), and files of either kind.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip {

/// A load with a name: a question of its own.
struct SpatialCase {
  std::string name;  ///< not empty
  WrenchBox wrench;  ///< all of it, with what is common to all cases
};

/// What a grasp file in space says.
struct SpatialGrasp {
  std::string name;                  ///< for people; may be empty
  std::optional<Units> units{};      ///< nothing if nobody gave them
  GraspBox box{{}, WrenchBox(6)};    ///< of cases, with the load that is common to them
  std::vector<SpatialCase> cases{};  ///< with different names
  std::vector<ContactId> assumed_stiffness{};  ///< as in GraspFile

  GraspDescription description() const { return {name, {}, units}; }  ///< its name and units
};

/// A grasp in the plane or in space.
using AnyGraspFile = std::variant<GraspFile, SpatialGrasp>;

/// For people; may be empty.
const std::string& name_of(const AnyGraspFile& file);

/// \{ As parse_grasp and read_grasp_file, which refuse grasps in space: either kind.
AnyGraspFile parse_any_grasp(std::string_view text, const std::string& file,
                             Intervals intervals = Intervals::kAllowed);
AnyGraspFile read_any_grasp_file(const std::string& path,
                                 Intervals intervals = Intervals::kAllowed);
/// \}

/// As of a GraspFile.
std::string write_grasp_file(const SpatialGrasp& grasp);

}  // namespace stickslip
