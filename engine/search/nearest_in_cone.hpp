// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The point of a cone in three dimensions that is nearest to another, in doubles: a proposal.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/motion/nearest_point.hpp"

namespace stickslip::search_detail {

/// A point of a cone, and the generators, at most three, of which it is a sum of positive
/// multiples.
struct ConePoint {
  Double3 point{};
  std::vector<std::size_t> generators{};
};

/// Returns the point nearest to the target of the cone of these vectors of length 1. (Lawson
/// and Hanson, Solving Least Squares Problems, 1974, chapter 23.) O(n) for each generator that
/// takes part on the way.
ConePoint nearest_in_cone(const std::vector<Double3>& units, const Double3& target);

}  // namespace stickslip::search_detail
