// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the engine is told of a question in space.
#pragma once

#include "stickslip/search/grasp_law.hpp"
#include "stickslip/space/spatial_question.hpp"

namespace stickslip::space_detail {

/// The law of its grasps, of a margin as it grows, with lengths enclosed to these bits.
inline GraspLaw law_of(const SpatialQuestion& question, unsigned bits) {
  std::optional<SpatialGrowth> growth;
  if (question.is_margin()) {
    growth = SpatialGrowth{question.direction.value_or(Vector6{}), question.preload_growth};
  }
  return GraspLaw(question.grasp.box, question.law, bits, growth);
}

}  // namespace stickslip::space_detail
