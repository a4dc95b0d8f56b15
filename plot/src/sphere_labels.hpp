// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Where texts go on the discs of a states plot.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/plot/svg.hpp"
#include "upper_half.hpp"

namespace stickslip {

/// Lambert's azimuthal equal-area projection of r >= 0 to the unit disc of the scene (y up),
/// turned so that a rotation lies in the direction of its centre, (-y, x) / r.
InkPoint project(const SpherePoint& p);

/// A place on a circle away from other circles and other labels, in the scene.
struct CircleSpot {
  InkPoint at;
  InkPoint to_positive;  ///< across the circle, to the positive side of its normal; length 1
};

/// By CircleId.
std::vector<CircleSpot> circle_spots(const ArrangementStructure& cells,
                                     const UpperHalf& upper_half);

/// A rectangle on the page with its centre and half its sides.
struct Box {
  InkPoint centre;
  InkPoint half;
};

double area(const std::vector<InkPoint>& polygon);

/// The centre of a box of this size in the polygon and off the taken boxes, near the polygon's
/// middle; nothing if there is no room.
std::optional<InkPoint> room_for(InkPoint half_size, const std::vector<InkPoint>& polygon,
                                 const std::vector<Box>& taken);

}  // namespace stickslip
