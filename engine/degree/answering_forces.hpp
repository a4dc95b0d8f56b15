// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact bounds of what forces do over a box, for proofs at rest and by sticking.
#pragma once

#include <vector>

#include "stickslip/engine/grasp_law.hpp"

namespace stickslip::degree_detail {

using WrenchRange = std::vector<Interval>;
using Rows = std::vector<RationalRow>;

/// Returns P' at this multiple, over the box.
Interval preload_at(const LawContact& c, const Rational& multiple);

/// Returns the loads at this multiple, over the box, by component.
WrenchRange loads_at(const GraspLaw& box, const Rational& multiple);

/// Adds the ends, over all corners, of the wrenches a N + S^T f with a in `normal`.
void add_wrenches(WrenchRange& sum, const LawContact& c, const RationalRow& friction,
                  const std::vector<Rational>& normal);

/// Returns the largest magnitude in an interval.
Rational largest(const Interval& interval);

/// Returns the bound of |f| that the format computes with: not below |f|, of 64 bits.
Rational length_above(const LawContact& contact, const RationalRow& f);

}  // namespace stickslip::degree_detail
