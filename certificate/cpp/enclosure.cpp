// SPDX-License-Identifier: MIT
#include "enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip_check {

static_assert(std::numeric_limits<double>::is_iec559 &&
              std::numeric_limits<double>::digits == 53);

Enclosure Enclosure::outwards(double low, double high) {
  constexpr double kRelative = 0x1p-50;
  constexpr double kLeast = 0x1p-1000;
  constexpr double kMost = 0x1p1000;
  Enclosure result;
  if (std::fabs(low) <= kMost && std::fabs(high) <= kMost) {
    result.low_ = low - (std::fabs(low) * kRelative + kLeast);
    result.high_ = high + (std::fabs(high) * kRelative + kLeast);
  } else {
    result.low_ = -std::numeric_limits<double>::infinity();
    result.high_ = std::numeric_limits<double>::infinity();
  }
  return result;
}

Enclosure::Enclosure(const Integer& x) : Enclosure(x, 0) {}

Enclosure::Enclosure(const Rational& x) {
  const double near = x.get_d();
  if (x != 0) *this = outwards(near, near);
}

Enclosure::Enclosure(const Integer& x, long exponent) {
  constexpr long kMostShift = 2000;  // more is no different
  long own = 0;
  const double first = mpz_get_d_2exp(&own, x.get_mpz_t());
  const long shift = std::clamp(own - exponent, -kMostShift, kMostShift);
  const double near = std::ldexp(first, static_cast<int>(shift));
  if (x != 0) *this = outwards(near, near);
}

Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  const double products[]{a.low_ * b.low_, a.low_ * b.high_, a.high_ * b.low_,
                          a.high_ * b.high_};
  // A product of infinity and 0 is no number, which minmax would pass over.
  if (std::isnan(products[0] + products[1] + products[2] + products[3])) {
    return Enclosure::outwards(products[0], std::numeric_limits<double>::infinity());
  }
  const auto [low, high] = std::minmax_element(std::begin(products), std::end(products));
  return Enclosure::outwards(*low, *high);
}

Enclosure larger(const Enclosure& a, const Enclosure& b) {
  Enclosure result;
  result.low_ = std::max(a.low_, b.low_);
  result.high_ = std::max(a.high_, b.high_);
  return result;
}

Enclosure smaller(const Enclosure& a, const Enclosure& b) {
  Enclosure result;
  result.low_ = std::min(a.low_, b.low_);
  result.high_ = std::min(a.high_, b.high_);
  return result;
}

Enclosure root_above(const Enclosure& a) {
  return Enclosure::outwards(std::sqrt(std::max(a.low_, 0.0)),
                             std::sqrt(std::max(a.high_, 0.0)));
}

Enclosure times_root_above(const Enclosure& a, const Enclosure& square) {
  return a * root_above(square);
}

}  // namespace stickslip_check
