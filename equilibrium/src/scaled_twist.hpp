// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Arithmetic with a motion of long rationals, as balance over many contacts gives it. With the
/// common denominator multiplied away, what is left has the contacts' own short denominators,
/// and the greatest common divisors that rationals take all the time stay cheap.
#pragma once

#include <vector>

#include "stickslip/equilibrium/problem.hpp"

namespace stickslip {

struct ScaledTwist {
  explicit ScaledTwist(const Twist& d);

  Rational scale;  ///< the common denominator of d, an integer
  Twist twist;     ///< scale * d, integers

  /// scale * v(d).
  Rational normal_coefficient(const ContactRow& row) const {
    return scale * row.preload - row.stiffness * power(row.normal, twist);
  }
};

/// The sum of rationals in pairs, so that long numbers meet only at the end.
Rational sum_in_pairs(std::vector<Rational> terms);

}  // namespace stickslip
