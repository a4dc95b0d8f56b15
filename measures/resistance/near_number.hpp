// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Doubles with a proved bound of their error: a filter for signs that exact numbers decide
/// where it does not.
#pragma once

#include <cmath>
#include <optional>

#include "stickslip/core/number.hpp"

namespace stickslip::resistance_detail {

/// An estimate of a real number x with |x - value| <= error. An error of 0 with the value 0
/// means that x is exactly 0; sums and products keep that. Beyond the range of doubles the
/// error is infinite or not a number, and no sign is known.
struct NearNumber {
  double value = 0;
  double error = 0;

  bool is_zero() const { return value == 0 && error == 0; }  ///< exactly
  /// Returns the sign of x, if it is certain.
  std::optional<int> sign() const {
    if (value > error) return 1;
    if (value < -error) return -1;
    if (is_zero()) return 0;
    return std::nullopt;
  }
};

/// \{ Bounds above the rounding of one operation: relative, and absolute for results near 0.
inline constexpr double kRounding = 0x1p-51;
inline constexpr double kLeast = 0x1p-1070;
/// \}

inline NearNumber operator+(const NearNumber& a, const NearNumber& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  const double value = a.value + b.value;
  return {value, (a.error + b.error) * (1 + kRounding) + std::fabs(value) * kRounding + kLeast};
}

inline NearNumber operator-(const NearNumber& a) {
  return {-a.value, a.error};
}

inline NearNumber operator-(const NearNumber& a, const NearNumber& b) {
  return a + -b;
}

inline NearNumber operator*(const NearNumber& a, const NearNumber& b) {
  if (a.is_zero() || b.is_zero()) return {};
  const double value = a.value * b.value;
  const double spread =
      std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error;
  return {value, spread * (1 + 4 * kRounding) + std::fabs(value) * kRounding + kLeast};
}

inline NearNumber near_number(const Rational& exact) {
  if (exact.is_zero()) return {};
  const double value = to_double(exact);
  return {value, std::fabs(value) * kRounding + kLeast};
}

}  // namespace stickslip::resistance_detail
