// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Arithmetic with long rationals, as balance over many contacts gives them.
#pragma once

#include <utility>
#include <vector>

#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// Returns the sum of the terms, added in pairs, so that long numbers meet only at the end.
inline Rational sum_in_pairs(std::vector<Rational> terms) {
  if (terms.empty()) return 0;
  while (terms.size() > 1) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k + 1 < terms.size(); k += 2)
      terms[kept++] = terms[k] + terms[k + 1];
    if (terms.size() % 2 == 1) terms[kept++] = std::move(terms.back());
    terms.resize(kept);
  }
  return std::move(terms.front());
}

/// A motion whose common denominator is multiplied away. Numbers computed from it have the
/// contacts' own short denominators, so the greatest common divisors that rationals take stay
/// cheap.
struct ScaledTwist {
  /// Scales the motion d.
  explicit ScaledTwist(const Twist& d) {
    Integer common = 1;
    for (const Rational& entry : coordinates(d)) common = lcm(common, denominator(entry));
    scale = common;
    twist = {scale * d.x, scale * d.y, scale * d.r};
  }

  Rational scale;  ///< the common denominator of d, an integer
  Twist twist;     ///< scale * d, integers

  /// Returns scale * v(d).
  Rational normal_coefficient(const ContactRow& row) const {
    return scale * row.preload - row.stiffness * power(row.normal, twist);
  }
};

}  // namespace stickslip
