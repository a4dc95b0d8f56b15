// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A convex set of loads that is no box, such as a cell of a plane of loads
/// (certificate/FORMAT.md, section 12).
#pragma once

#include <vector>

#include "stickslip/core/row.hpp"
#include "stickslip/engine/reals.hpp"

namespace stickslip {

/// A corner of a set of loads, or a direction in which it goes on without end.
struct LoadGenerator {
  RationalRow load;    ///< the load, by coordinate of motions
  RationalRow strict;  ///< the values of the strict functions there
  Reals rounded{};     ///< the load in the law's units; scaled to length 1 if a direction
};

/// The set that corners and directions generate, without the points where a strict function
/// vanishes. Strict functions are linear and nowhere negative.
struct LoadHull {
  std::vector<LoadGenerator> corners;     ///< the corners, at least one
  std::vector<LoadGenerator> directions;  ///< the directions, which are not 0

  /// Returns the largest work of a corner on a virtual twist.
  Rational most_work(const Row& y) const;
  /// Returns the corner that does this work, in doubles.
  const Reals& worst(const Reals& y) const;
  /// Returns whether a direction does positive work on a virtual twist.
  bool is_unbounded(const Row& y) const;
  /// Returns whether a strict function is 0 on all directions that do no work on the twist and,
  /// with `at_corners`, on all corners that do the most. Requires that no direction does
  /// positive work on it.
  bool bars(const Row& y, bool at_corners) const;
};

}  // namespace stickslip
