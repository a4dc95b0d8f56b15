// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A problem and the rays of a region in double precision, with the error bounds that let a
/// double decide a sign. What they leave open is decided in integers.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "nearest_point.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/equilibrium/problem.hpp"

namespace stickslip {

using Double4 = std::array<double, 4>;

inline double dot(const Double4& a, const Double4& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// One contact; every entry is within one unit roundoff of the exact value if that is moderate.
struct ContactDoubles {
  Double3 normal;      ///< N
  Double3 friction;    ///< mu T
  Double4 slip;        ///< tau_i
  Double4 separation;  ///< v_i
  double stiffness;
  bool frictionless;
};

struct DoubleModel {
  explicit DoubleModel(const Problem& problem);

  /// The end whose load does the most work on the twist. Every h >= 0, so it is the same for
  /// all rays.
  std::size_t hardest_load(const Double3& twist) const;

  std::vector<ContactDoubles> contacts;
  std::vector<Double3> loads;        ///< at the ends of the range
  std::vector<double> multiples;     ///< there
  std::optional<Double3> recession;  ///< of the loads
  double length;  ///< a typical distance, to make torques and forces comparable
  double force;   ///< a typical force

  /// Whether all entries are moderate: 0, or between 2^-200 and 2^200. No product of a load, or
  /// of an N and a v, with a ray and a twist of 50 bits then overflows, and what it loses by
  /// underflow is below the absolute errors that are allowed for. Otherwise doubles decide
  /// nothing.
  bool is_moderate = true;

 private:
  double read(const Rational& value);
  Double3 read(const Wrench& w) { return {read(w.x), read(w.y), read(w.torque)}; }
};

/// A ray scaled by a power of two to entries of about 1; within two unit roundoffs, or within
/// 2^-1073 where an entry is so small that it underflows.
Double4 to_doubles(const IntegerVector4& x);

/// value = dot(function, x) in double, with a moderate function and a ray as above: its sign,
/// if the error bound decides.
inline std::optional<Sign> certain_sign(const Double4& function, const Double4& x,
                                        double& value) {
  double magnitude = 0;
  value = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    const double product = function[j] * x[j];
    value += product;
    magnitude += product < 0 ? -product : product;
  }
  // Factors 3u, products u, sums 3u, second order: below 8u, with u = 2^-53; magnitude itself
  // is rounded. What underflows, 2^-1073 in an entry of the ray, is at most 2^-873 in a
  // product.
  constexpr double kRelativeError = 1.2e-15;
  constexpr double kUnderflow = 1e-250;
  const double bound = kRelativeError * magnitude + kUnderflow;
  if (value > bound) return Sign::kPositive;
  if (value < -bound) return Sign::kNegative;
  return std::nullopt;  // also for NaN
}

}  // namespace stickslip
