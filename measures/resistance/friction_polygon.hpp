// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The polygon of friction that may lie anywhere between the edges of cones.
#pragma once

#include <vector>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip::resistance_detail {

/// A step along a polygon: a segment [-1, 1] t_k of a sum, and the end of it that the step
/// leads to.
struct PolygonStep {
  std::size_t segment;
  int end;  ///< -1 or 1
};

/// Returns half of the way round the polygon that the segments add up to, seen along an axis
/// that none of them is parallel to. The way is counterclockwise. At its beginning each segment
/// is at the end opposite to its step; the other half takes the opposite of each step, in the
/// same order. (Steps that look parallel make up one edge.)
std::vector<PolygonStep> half_way_round(const std::vector<IntegerVector3>& tangents,
                                        const IntegerVector3& axis);

}  // namespace stickslip::resistance_detail
