// SPDX-License-Identifier: MIT
#include "enclosure.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip_check {

static_assert(std::numeric_limits<double>::is_iec559 &&
              std::numeric_limits<double>::digits == 53);

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

}  // namespace stickslip_check
