// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Forces of contacts whatever their stiffness.
#pragma once

#include <vector>

#include "stickslip/core/row.hpp"

namespace stickslip {

/// The force of one contact on the object: the normal coefficient a >= 0, and friction. In the
/// plane friction is one number, the coefficient of T; in space it is f, orthogonal to n.
struct RigidForce {
  Rational normal{0};      ///< a, the force over |n|
  RationalRow friction{};  ///< b, or f
};
/// The forces by ContactId.
using RigidForces = std::vector<RigidForce>;

}  // namespace stickslip
