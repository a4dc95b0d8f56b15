// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads GMP numbers that fit a machine word, without a library call or a copy.
#pragma once

#include <cstdint>
#include <limits>

#include "stickslip/core/number.hpp"

namespace stickslip::lp_detail {

static_assert(sizeof(mp_limb_t) == 8, "GMP limbs are read as 64-bit words");

inline mpz_srcptr numerator_of(const Rational& value) {
  return mpq_numref(value.gmp());
}
inline mpz_srcptr denominator_of(const Rational& value) {
  return mpq_denref(value.gmp());
}

/// Reads a number. Returns false, and leaves `to` unchanged, unless |from| < 2^63.
inline bool read_small(mpz_srcptr from, std::int64_t& to) {
  if (mpz_size(from) > 1) return false;
  const mp_limb_t magnitude = mpz_getlimbn(from, 0);  // 0 when there is no limb
  if (magnitude > static_cast<mp_limb_t>(std::numeric_limits<std::int64_t>::max()))
    return false;
  const auto value = static_cast<std::int64_t>(magnitude);
  to = mpz_sgn(from) < 0 ? -value : value;
  return true;
}

}  // namespace stickslip::lp_detail
