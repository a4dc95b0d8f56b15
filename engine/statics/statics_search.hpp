// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The decision of one load of a model of statics, with evidence in the model's coordinates.
#pragma once

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "statics_model.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::statics_detail {

/// The linear program of forces along the edges of cones, where these are rational.
class EdgeProgram {
 public:
  /// Returns nothing if the program would be large, or edges are not rational.
  static std::optional<EdgeProgram> of(const StaticsModel& model);

  /// Returns the program of forces, and of multiples of more loads, that balance the load
  /// together. The multiples are the last variables.
  LinearProgram balancing(const RationalRow& load, const std::vector<RationalRow>& more,
                          VariableKind kind) const;
  /// Returns the forces of a point, or ray, of the program.
  std::vector<ConeForce> forces_at(const RationalRow& point) const;

 private:
  explicit EdgeProgram(const StaticsModel& model) : model_(&model) {}

  const StaticsModel* model_;
  std::vector<std::pair<std::size_t, Rational>>
      edges_;  ///< of a cone, and its friction for a = 1
};

/// Forces by cone that balance a load, a motion that no force opposes and the load goes along,
/// or neither, near the border of both.
using ModelAnswer = std::variant<std::vector<ConeForce>, RationalRow, std::monostate>;

/// Returns a motion that no force opposes and the load goes along, if doubles find one.
std::optional<RationalRow> unopposed_motion(const StaticsModel& model, const RationalRow& load);
/// Decides a load, in the model's coordinates.
ModelAnswer decide_load(const StaticsModel& model, const RationalRow& load);
/// Does the same; `needs_long` says whether doubles are of no use, and becomes it if they are
/// not: as when loads or frictions that are asked about come near a border.
ModelAnswer decide_load(const StaticsModel& model, const RationalRow& load, bool& needs_long);

}  // namespace stickslip::statics_detail
