// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Vectors whose number of coordinates is known at run time, with what integer_vector.hpp has
/// for those of fixed length.
#pragma once

#include <cstddef>
#include <vector>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip {

/// Integers: a point, a plane, or a virtual twist.
using Row = std::vector<Integer>;
/// Fractions.
using RationalRow = std::vector<Rational>;

/// \{ The sum of a_j b_j over the coordinates that both have: what a function of points (d, h,
/// l) says of a motion d alone.
Integer dot(const Row& a, const Row& b);
Rational dot(const RationalRow& a, const RationalRow& b);
/// \}

bool is_zero(const Row& a);                    ///< whether every entry is 0
Row negated(Row a);                            ///< -a
Row primitive(Row a);                          ///< over the greatest common divisor
Row primitive_multiple(const RationalRow& a);  ///< by a positive factor; 0 stays 0

}  // namespace stickslip
