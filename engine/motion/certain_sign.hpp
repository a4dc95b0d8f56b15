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

/// The error of the value at a ray as in_doubles() gives it of a moderate function, or of one
/// in integers rounded as rays are, by the sum of the absolute values of its five products.
inline double rounding_bound(double magnitude) {
  // Factors 4u, products u, sums 4u, second order: below 10u, with u = 2^-53; magnitude itself
  // is rounded. What underflows, 2^-1073 in a rounded entry, is at most 2^-873 in a product.
  constexpr double kRelativeError = 1.2e-15;
  constexpr double kUnderflow = 1e-250;
  return kRelativeError * magnitude + kUnderflow;
}

/// value = dot(function, x) in double, with a function and a ray as above: its sign, if the
/// error bound decides.
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
