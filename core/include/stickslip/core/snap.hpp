// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Replacing normals of irrational length by rational unit vectors nearby, so that a
/// preloaded contact has a rational normal force.
#pragma once

#include <string>
#include <vector>

#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// The remedy in errors about a normal that must have a rational length and has none.
inline constexpr const char* kSnapRemedy =
    "run stickslip snap GRASP -o FILE, and ask about FILE";

/// A contact whose normal was replaced.
struct SnappedNormal {
  ContactId contact;  ///< whose normal it is
  Vector2 before;     ///< as it was given
  Vector2 after;      ///< rational, of length exactly 1
  std::string moved;  ///< upper bound of |after - before/|before||, a decimal
};

/// A grasp with rational lengths of normals, and what was done for that.
struct SnapResult {
  Grasp grasp;                         ///< with the new normals, otherwise as it was
  std::vector<SnappedNormal> snapped;  ///< those that were replaced, by ContactId
};

/// Replaces every normal of irrational length by a rational unit vector u with
/// |u - n/|n|| <= tolerance, decided exactly, using the rational parametrisation
/// u = ((1-t^2), 2t)/(1+t^2) of the circle with the simplest fraction t (Stern-Brocot) that
/// serves. Normals of rational length are left alone. Throws InputError unless
/// 0 < tolerance < 1.
///
/// The normal is first brought to 0 <= n_y <= n_x by signs and a swap of x and y, and u is
/// brought back. So 0 <= t < 1, u depends on the direction of n alone, changes sign with n_x
/// and n_y, and is swapped with them (except at |n_x| = |n_y|, where no rational u has that
/// symmetry). Each normal costs O(log^2(1/tolerance)) operations on numbers of
/// O(log(1/tolerance)) bits.
SnapResult snap_normals(const Grasp& grasp, const Rational& tolerance);

}  // namespace stickslip
