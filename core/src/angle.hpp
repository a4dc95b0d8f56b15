// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Rational directions of angles in degrees.
#pragma once

#include "stickslip/core/grasp.hpp"

namespace stickslip::core_detail {

/// A direction in the plane that stands for an angle.
struct AngleDirection {
  Vector2 vector;
  bool is_rounded;  ///< whether the true direction is irrational
};

/// Returns the direction at an angle from the x axis, counterclockwise, by the rule of
/// certificate/FORMAT.md, section 1, which all readers share: the true direction at multiples
/// of 45 degrees, such as (1, 1) at 45, and else a rational unit vector at a distance below
/// 1e-9 from the true one.
AngleDirection direction_at(const Rational& degrees);

}  // namespace stickslip::core_detail
