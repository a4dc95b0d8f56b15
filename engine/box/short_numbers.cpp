// SPDX-License-Identifier: GPL-3.0-or-later
#include "short_numbers.hpp"

namespace stickslip::box_detail {

Rational power_of_two_above(const Rational& size) {
  Rational power = 1;
  while (power < size) power *= 2;
  while (!size.is_zero() && power / 2 >= size) power /= 2;
  return power;
}

Rational short_middle(const Rational& a, const Rational& b) {
  const Rational exact = (a + b) / 2;
  for (int bits = 4; bits <= 40; bits += 4) {
    const Rational unit = (b - a) / (Integer(1) << static_cast<unsigned>(bits));
    // The grain 1 / power is the largest binary one that is not above that unit.
    const Integer scale =
        Integer(1) + numerator(Rational(1) / unit) / denominator(Rational(1) / unit);
    const Rational power = power_of_two_above(Rational(scale));
    const Rational scaled = exact * power;
    const Rational rounded = Rational(numerator(scaled) / denominator(scaled)) / power;
    if (a < rounded && rounded < b) return rounded;
  }
  return exact;
}

}  // namespace stickslip::box_detail
