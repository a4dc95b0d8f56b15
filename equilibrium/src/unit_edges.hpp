// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The points that span a grasp wrench space.
#pragma once

#include <vector>

#include "stickslip/equilibrium/problem.hpp"

namespace stickslip {

/// The wrenches of a unit normal force with friction on either edge of the cone, their torques
/// divided by `length`.
struct UnitEdges {
  Vector3 plus;
  Vector3 minus;
};

/// Throws InputError at a normal of irrational length.
std::vector<UnitEdges> unit_edges(const Problem& problem, const Rational& length);

}  // namespace stickslip
