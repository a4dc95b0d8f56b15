// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A problem and points in double precision, with bounds of the rounding.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact_groups.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/equilibrium/problem.hpp"
#include "stickslip/equilibrium/search/nearest_point.hpp"

namespace stickslip::equilibrium_detail {

using Double5 = std::array<double, 5>;

/// One contact; every entry is within one unit roundoff of the exact value if that is moderate.
struct ContactDoubles {
  Double3 normal;      ///< N
  Double3 friction;    ///< mu T
  Double5 slip;        ///< tau_i
  Double5 separation;  ///< v_i
  double stiffness;
  bool frictionless;
  /// \{ Bounds of the rounding of the functions' values at points with entries of at most 1.
  double slip_error;
  double separation_error;
  /// \}
};

struct DoubleModel {
  explicit DoubleModel(const Problem& problem);

  std::vector<ContactDoubles> contacts;
  Double3 load;          ///< w
  Double3 growth;        ///< u, of a family
  Double3 start{};       ///< the load at the high end of the multiples, or u: where to begin
  double length;         ///< a typical distance, to make torques and forces comparable
  double force = 0;      ///< a typical force
  double stiffness = 0;  ///< of all contacts

  /// Whether all entries are moderate: 0, or between 2^-200 and 2^200. No product of a load, or
  /// of an N and a v, with a ray and a twist of 50 bits then overflows, and what it loses by
  /// underflow is below the absolute errors that are allowed for. Otherwise doubles decide
  /// nothing.
  bool is_moderate = true;

  ContactGroups groups;  ///< of the contacts

 private:
  double read(const Rational& value);
  Double3 read(const Wrench& w) { return {read(w.x), read(w.y), read(w.torque)}; }
};

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

}  // namespace stickslip::equilibrium_detail
