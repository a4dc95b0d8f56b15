// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A problem and points in double precision, with bounds of the rounding.
#pragma once

#include <cstdint>
#include <vector>

#include "contact_groups.hpp"
#include "engine/motion/certain_sign.hpp"
#include "engine/motion/nearest_point.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// One contact; every entry is within one unit roundoff of the exact value if that is moderate.
struct ContactDoubles {
  Double3 normal;      ///< N
  Double3 friction;    ///< mu T
  Double5 slip;        ///< tau_i
  Double5 separation;  ///< v_i
  double stiffness;    ///< k
  bool frictionless;   ///< mu is 0
  /// \{ Bounds of the rounding of the functions' values at points with entries of at most 1.
  double slip_error;
  double separation_error;
  /// \}
};

/// A problem in doubles.
struct DoubleModel {
  /// Rounds the numbers of this problem.
  explicit DoubleModel(const Problem& problem);

  std::vector<ContactDoubles> contacts;  ///< contacts by ContactId
  Double3 load;                          ///< w
  Double3 growth;                        ///< u, for a family
  Double3 start{};       ///< the load at the high end of the multiples, or u, to begin with
  double length;         ///< a typical distance; it makes torques and forces comparable
  double force = 0;      ///< a typical force
  double stiffness = 0;  ///< the sum over all contacts

  /// Whether all entries are moderate: 0, or between 2^-200 and 2^200. No product of a load, or
  /// of an N and a v, with a ray and a twist of 50 bits then overflows, and what it loses by
  /// underflow is below the absolute errors that are allowed for. Otherwise doubles decide
  /// nothing.
  bool is_moderate = true;

  ContactGroups groups;  ///< the contacts in groups

 private:
  double read(const Rational& value);
  Double3 read(const Wrench& w) { return {read(w.x), read(w.y), read(w.torque)}; }
};

}  // namespace stickslip
