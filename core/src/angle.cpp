// SPDX-License-Identifier: GPL-3.0-or-later
#include "angle.hpp"

#include <utility>

namespace stickslip::core_detail {
namespace {

Integer floor_of(const Rational& value) {
  const Integer n = numerator(value);
  const Integer d = denominator(value);
  Integer quotient = n / d;
  if (n.sign() < 0 && quotient * d != n) quotient -= 1;
  return quotient;
}

Rational power_of_2(unsigned long bits) {
  return Rational(Integer(1) << bits);
}

/// Returns 1 - y/(a (a+1)) (1 - y/((a+2) (a+3)) (...)) of five such factors, y = x^2: of a = 1
/// the cosine of x, of a = 2 the sine over x, to 12 digits for |x| below 0.4.
Rational nested_series(const Rational& y, int a) {
  Rational sum = 1;
  for (int k = 4; k >= 0; --k) {
    const int first = a + 2 * k;
    sum = 1 - y / Rational(first * (first + 1)) * sum;
  }
  return sum;
}

}  // namespace

AngleDirection direction_at(const Rational& degrees) {
  const Integer quarter = floor_of((degrees + 45) / 90);
  const Rational rest = degrees - 90 * Rational(quarter);  // from -45 to below 45
  Vector2 direction{1, 0};
  bool is_rounded = false;
  if (rest == -45) {
    direction.y = -1;
  } else if (!rest.is_zero()) {
    // Half the angle in radians; pi has 30 digits, and x 64 bits.
    static const Rational kPi = parse_rational("3.14159265358979323846264338328");
    const Rational x = Rational(floor_of(rest * kPi / 360 * power_of_2(64))) / power_of_2(64);
    const Rational y = x * x;
    const Rational tangent = x * nested_series(y, 2) / nested_series(y, 1);
    const Rational t =
        Rational(floor_of(tangent * power_of_2(32) + Rational(1, 2))) / power_of_2(32);
    const Rational over = 1 + t * t;
    direction = {(1 - t * t) / over, 2 * t / over};
    is_rounded = true;
  }
  const Integer turns = quarter - 4 * floor_of(Rational(quarter) / 4);
  for (Integer k = 0; k < turns; ++k) {
    direction = {-direction.y, direction.x};
  }
  return {std::move(direction), is_rounded};
}

}  // namespace stickslip::core_detail
