// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The sign of a number, as its own type. "Unknown" is not a sign: filters that may
/// fail return std::optional<Sign>.
#pragma once

#include <cstdint>

#include "stickslip/core/number.hpp"

namespace stickslip {

/// Negative, zero or positive: three values, of which zero never means "not known".
enum class Sign : std::int8_t { kNegative = -1, kZero = 0, kPositive = 1 };

/// \{ Returns the sign of a number, exactly.
constexpr Sign sign_of_int(int value) {
  return value > 0 ? Sign::kPositive : value < 0 ? Sign::kNegative : Sign::kZero;
}
inline Sign sign_of(const Rational& value) {
  return sign_of_int(value.sign());
}
inline Sign sign_of(const Integer& value) {
  return sign_of_int(value.sign());
}
/// \}

/// Returns -1, 0 or 1.
constexpr int to_int(Sign sign) {
  return static_cast<int>(sign);
}
/// Returns the sign of -x, given that of x.
constexpr Sign operator-(Sign sign) {
  return static_cast<Sign>(-to_int(sign));
}
/// Returns the sign of a product, given those of its factors.
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(to_int(a) * to_int(b));
}

/// Returns '+', '-' or '0', as in the slip states that the programs print.
constexpr char to_char(Sign sign) {
  return sign == Sign::kPositive ? '+' : sign == Sign::kNegative ? '-' : '0';
}

}  // namespace stickslip
