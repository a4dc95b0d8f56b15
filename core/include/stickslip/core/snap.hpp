// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Replacing normals of irrational length by rational unit vectors nearby, so that a
/// preloaded contact has a rational normal force.
#pragma once

#include <string>
#include <vector>

#include "stickslip/core/box.hpp"

namespace stickslip {

/// The remedy in errors about a normal that must have a rational length and has none.
inline constexpr const char* kSnapRemedy =
    "run stickslip snap GRASP -o FILE, and ask about FILE";

/// A contact whose normal was replaced. Normals have two numbers in the plane, three in space.
struct SnappedNormal {
  ContactId contact;   ///< whose normal it is
  RationalRow before;  ///< the normal as it was given
  RationalRow after;   ///< the new normal, rational and of length exactly 1
  std::string moved;   ///< an upper bound of |after - before/|before||, a decimal
};

/// A grasp whose normals have rational lengths, and the normals that were replaced for that.
template <class SomeGrasp>
struct SnapResultOf {
  SomeGrasp grasp;                     ///< the grasp with the new normals, otherwise as it was
  std::vector<SnappedNormal> snapped;  ///< the replaced normals, by ContactId
};

/// The result of a grasp in the plane.
using SnapResult = SnapResultOf<Grasp>;
/// The result of a box, in the plane or in space.
using BoxSnapResult = SnapResultOf<GraspBox>;

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

/// Does the same for any box. In the plane the normals of single grasps and of boxes are
/// treated alike; in space they go through the stereographic projection of the sphere. Where
/// n_z is the largest entry of n and none is below 0, u = (2 s, 2 t, 1 - s^2 - t^2) / (1 + s^2
/// + t^2), with s and t in [0, 1/2] rounded to the shortest binary fractions of one length that
/// serve. Other normals are brought there by signs and by a swap of the largest entry with z,
/// and u is brought back. So u depends on the direction of n alone, changes sign with its
/// entries, and is 0 where n is. Each normal costs O(log(1/tolerance)) operations on numbers of
/// O(log(1/tolerance)) bits.
BoxSnapResult snap_normals(const GraspBox& grasp, const Rational& tolerance);

}  // namespace stickslip
