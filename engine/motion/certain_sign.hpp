// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Signs of linear functions from doubles, where their rounding leaves no doubt.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "stickslip/core/sign.hpp"

namespace stickslip {

/// A point (d, h, l) of the plane, or a function of such points, in doubles.
using Double5 = std::array<double, 5>;

/// Returns a bound of the error of a function's value at a ray, from the sum of the absolute
/// values of its five products. The ray is as in_doubles() gives it. The function is moderate,
/// or in integers and rounded as rays are.
inline double rounding_bound(double magnitude) {
  // The relative errors are 4u for factors, u for products, 4u for sums, and second order:
  // below 10u, with u = 2^-53; magnitude itself is rounded. An underflow, 2^-1073 in a rounded
  // entry, is at most 2^-873 in a product.
  constexpr double kRelativeError = 1.2e-15;
  constexpr double kUnderflow = 1e-250;
  return kRelativeError * magnitude + kUnderflow;
}

/// Sets value to dot(function, x) in double, for a function and a ray as above. Returns its
/// sign, or nothing if the error bound does not decide it.
inline std::optional<Sign> certain_sign(const Double5& function, const Double5& x,
                                        double& value) {
  double magnitude = 0;
  value = 0;
  for (std::size_t j = 0; j < 5; ++j) {
    const double product = function[j] * x[j];
    value += product;
    magnitude += product < 0 ? -product : product;
  }
  const double bound = rounding_bound(magnitude);
  if (value > bound) return Sign::kPositive;
  if (value < -bound) return Sign::kNegative;
  return std::nullopt;  // also for NaN
}

}  // namespace stickslip
