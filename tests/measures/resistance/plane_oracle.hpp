// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a union of cells is, point by point and without any geometry: a point is in a cell iff
/// a linear program over its generators says so.
#pragma once

#include <string>
#include <vector>

#include "stickslip/measures/plane_union.hpp"

namespace stickslip::test {

using Generators = std::vector<HomogeneousPoint>;

/// p = sum of nonnegative multiples of the generators, exactly.
bool generates(const Generators& generators, const PlanePoint& p);

bool is_in_some(const std::vector<PlaneCell>& cells, const PlanePoint& p);

/// Points with coordinates in {-3/2, -1, -1/2, 0, 1/3, 1, 5/2}.
const std::vector<PlanePoint>& probes();

/// All cells with generators of coordinates in {-1, 0, 1}: at most `points` points and at most
/// `rays` directions. Each once.
std::vector<PlaneCell> small_world(int points, int rays);

/// Fails the running test unless `found` is the union of the cells, in the form that is
/// promised: contains() on probes; beside each edge of an area, on either side; beside curves;
/// around points.
void expect_union(const std::vector<PlaneCell>& cells, const PlaneUnion& found);

/// For failure messages.
std::string describe(const std::vector<PlaneCell>& cells);
std::string describe(const PlaneUnion& region);

}  // namespace stickslip::test
