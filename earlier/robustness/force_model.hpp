// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A grasp as the measures of internal forces see it (stickslip/earlier/robustness.hpp).
#pragma once

#include <array>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/earlier/robustness.hpp"

namespace stickslip::robustness_detail {

/// A row of the grasp map as a factor times a vector of integers.
struct ScaledRow {
  Row integers;
  Rational factor;

  explicit ScaledRow(const RationalRow& row);  ///< keeps the row
  RationalRow row() const;                     ///< the row
};

/// The doubles of a wrench; in the plane the last three are 0.
using Doubles = std::array<double, 6>;
/// Returns the nearest doubles.
Doubles doubles_of(const RationalRow& row);
/// Returns a.b.
inline double dot(const Doubles& a, const Doubles& b) {
  double sum = 0;
  for (std::size_t j = 0; j < 6; ++j) sum += a[j] * b[j];
  return sum;
}

/// A unit direction of friction among the tangents of a contact. In the plane it is one of the
/// two signs.
struct FrictionDirection {
  RationalRow along;  ///< by tangent; its length is exactly 1
};

/// Returns a direction at nearly this angle from the first tangent.
FrictionDirection direction_at(double angle);

/// Returns the corners of a nearly regular polygon, the first along the first tangent.
std::vector<FrictionDirection> corners_of_polygon(std::size_t count);

/// A contact by its rows of the grasp map.
struct ForceContact {
  ScaledRow normal;                 ///< N
  std::vector<ScaledRow> tangents;  ///< T: one in the plane, two in space, orthonormal
  RationalRow n;                    ///< the unit normal
  std::vector<RationalRow> t;       ///< the unit tangents
  Rational friction;                ///< mu
  ShortRoot root;                   ///< encloses sqrt(1 + mu^2)
  Rational stiffness;
  Rational most_force;  ///< f

  Doubles normal_double{};
  std::array<Doubles, 2> tangents_double{};
  double friction_double = 0;
  double root_double = 1;
  double stiffness_double = 1;
  double most_force_double = 1;
  std::vector<FrictionDirection> edges{};  ///< of the pyramid in place of the cone, or none

  bool can_stick() const { return !friction.is_zero(); }  ///< whether a distance may be > 0
  bool is_round() const { return tangents.size() == 2 && edges.empty(); }  ///< the cone
};

/// The grasp.
struct ForceModel {
  std::size_t coordinates = 3;         ///< 3 in the plane, 6 in space
  std::vector<ForceContact> contacts;  ///< by ContactId
  RationalRow load;                    ///< w, torques over the length
  Doubles load_double{};
  Rational most_force{0};  ///< the largest f
  double most_force_double = 1;
  bool is_uniform = true;  ///< whether all stiffnesses are the same

  /// Reads a grasp without uncertain numbers.
  ForceModel(const GraspBox& grasp, const RobustnessOptions& options);
  /// Returns the columns of G in these states.
  std::vector<RationalRow> columns(const std::vector<SpringState>& states) const;
};

}  // namespace stickslip::robustness_detail
