// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What is asked about all grasps in a box, in the plane or in space.
#pragma once

#include <string>
#include <variant>

#include "stickslip/space/spatial_question.hpp"

namespace stickslip {

/// \{ The engine whose numbers may be intervals, in the plane and in space.
inline constexpr const char* kIntervalsEngine = "intervals";
inline constexpr const char* kSpaceEngine = "space";
/// \}

/// A box of grasps, perhaps of one point, and what is said beside an answer about it.
struct AskedBox {
  GraspBox box;                  ///< all grasps
  GraspBox centre;               ///< the one in the middle
  GraspDescription description;  ///< name, outline and units of the grasp
  std::string case_name;         ///< may be empty
  NormalLaw law;                 ///< of every contact
  Tolerances uncertain;          ///< as asked

  /// The one that answers.
  const char* engine() const { return box.in_space() ? kSpaceEngine : kIntervalsEngine; }
};

/// \{ Of a question that is not a margin.
AskedBox asked_box(const Question& question);
AskedBox asked_box(const SpatialQuestion& question);
AskedBox asked_box(const std::variant<Question, SpatialQuestion>& question);
/// \}

}  // namespace stickslip
