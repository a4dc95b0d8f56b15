// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Friction that may lie anywhere between the edges of cones, as a polygon.
#pragma once

#include <vector>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip::resistance_detail {

/// A segment [-1, 1] t_k of a sum, and the end of it that a step leads to.
struct PolygonStep {
  std::size_t segment;
  int end;  ///< -1 or 1
};

/// Seen along an axis that none of them is parallel to, segments add up to a polygon. Half of
/// the way round it, counterclockwise: at the beginning each is at the other end than that of
/// its step; after all of the steps comes the opposite of each, in the same order. (Steps that
/// look parallel make up one edge.)
std::vector<PolygonStep> half_way_round(const std::vector<IntegerVector3>& tangents,
                                        const IntegerVector3& axis);

}  // namespace stickslip::resistance_detail
