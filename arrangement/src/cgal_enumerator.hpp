// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the reference enumerator does before it calls CGAL: a linear change of coordinates that
/// keeps an arrangement of great circles clear of the poles and of the meridian plane y = 0.
///
/// An algorithm that cuts the sphere along a meridian from pole to pole has special cases
/// for circles through a pole and for vertices on the cut. They can be avoided: for any
/// regular M, n.d = (Mn).(M^-T d), so the circles with normals Mn have the same cells with
/// the same signs.
#pragma once

#include <vector>

#include "stickslip/arrangement/great_circles.hpp"

namespace stickslip::arrangement_detail {

/// The mapped normals Mn of distinct circles, in the same order, for an integer matrix M with
/// det M != 0 such that, exactly,
///   - every mapped normal has z != 0: no circle passes through a pole;
///   - every cross product of two mapped normals has y != 0: no vertex lies on y = 0.
/// Deterministic. O(k^2) operations for each matrix tried, and the first usually serves.
/// Throws ContractError if a normal is zero or two are parallel: then no matrix serves.
std::vector<IntegerVector3> in_generic_position(const std::vector<IntegerVector3>& normals);

}  // namespace stickslip::arrangement_detail
