// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The loads that a grasp resists without moving.
#pragma once

#include <optional>

#include "mode_image.hpp"
#include "stickslip/measures/plane_cell.hpp"

namespace stickslip::resistance_detail {

/// Returns the wrenches of the plane that are resisted at d = 0, under preloads alone. Friction
/// anywhere in its cones makes them a zonotope; the section by the plane has its vertices on
/// edges of that. The edges along one generator come from the vertices of the zonotope seen
/// along it, a polygon, of which one goes round once. O(m^2 log m) signs and O(m^2) sums for m
/// contacts.
std::optional<PlaneCell> still_cell(const MotionRays& rays, const ModeImages& images);

}  // namespace stickslip::resistance_detail
