// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a proof by degree is about.
#pragma once

#include "rounded_box.hpp"
#include "stickslip/engine/force_span.hpp"
#include "stickslip/engine/law.hpp"

namespace stickslip::degree_detail {

/// The grasps that are to be proved stable.
struct DegreeSubject {
  RoundedGrasp grasp;      ///< the grasp in the middle, or the only one
  ForceSpan span;          ///< the span of all grasps' forces
  NormalLaw law;           ///< the law of all contacts
  const GraspLaw* box;     ///< nullptr: one grasp in the plane
  const GraspLaw* middle;  ///< the law of the grasp in the middle of the box; nullptr as before
};

}  // namespace stickslip::degree_detail
