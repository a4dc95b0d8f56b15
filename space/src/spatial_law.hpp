// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the engine is told of a question in space.
#pragma once

#include "stickslip/equilibrium/question.hpp"
#include "stickslip/search/grasp_law.hpp"

namespace stickslip::space_detail {

/// The law of its grasps, of a margin as it grows, with lengths enclosed to these bits.
inline GraspLaw law_of(const Question& question, unsigned bits) {
  std::optional<GrowthRates> growth;
  if (question.is_margin()) {
    growth = GrowthRates{question.direction.value_or(RationalRow{}), question.preload_growth};
  }
  return GraspLaw(*question.box(), question.law, bits, growth);
}

}  // namespace stickslip::space_detail
