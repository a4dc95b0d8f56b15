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
  RationalRow load;    ///< by coordinate of motions
  RationalRow strict;  ///< values of the strict functions
  Reals rounded{};     ///< in the law's units; of a direction, of length 1
};

/// What corners and directions generate, without the points where a strict function is 0: these
/// are linear and nowhere negative.
struct LoadHull {
  std::vector<LoadGenerator> corners;     ///< one at least
  std::vector<LoadGenerator> directions;  ///< not 0

  /// The largest work of a corner on a virtual twist.
  Rational most_work(const Row& y) const;
  /// The corner that does it, in doubles.
  const Reals& worst(const Reals& y) const;
  /// Whether a direction does work on a virtual twist.
  bool is_unbounded(const Row& y) const;
  /// Whether a strict function is 0 on all directions that do none, if `at_corners` on all
  /// corners that do the most, too. Of a twist on which none does any.
  bool bars(const Row& y, bool at_corners) const;
};

}  // namespace stickslip
