// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Measures of the grasp map G alone, which know neither load nor preloads: how much its
/// singular values are and differ, and where the contacts are.
///
/// G has the wrenches of unit normals as columns, and those of unit tangents of contacts with
/// friction, with torques divided by a length L. Its least singular value is how much of any
/// wrench of size 1 a unit of forces gives at least; sqrt(det(G G^T)) is the volume of the
/// ellipsoid of wrenches that unit forces give, up to a constant factor; the isotropy is the
/// least singular value over the largest.
///
/// Sources: Li and Sastry, "Task-oriented optimal grasping by multifingered robot hands", IEEE
/// J. Robotics and Automation 4(1), 1988; Kim and Oh, "Evaluation of grasping performance",
/// 1991; Ding, Liu and Wang, "Computation of 3-D form-closure grasps", IEEE Trans. Robotics and
/// Automation 17(4), 2001; they are collected in Roa and Suarez, "Grasp quality measures:
/// review and performance", Autonomous Robots 38(1), 2015.
#pragma once

#include "stickslip/core/box.hpp"

namespace stickslip {

/// The measures of one grasp.
struct GraspMapMeasures {
  /// \{ Bounds of the squares of the least and the largest singular value; 0 and 0 of the least
  /// if G has not full rank.
  Interval least_square;
  Interval largest_square;
  /// \}
  Rational determinant;  ///< det(G G^T), exactly
};

/// Returns the measures of one grasp, in the plane or in space, without uncertain numbers and
/// of one body. The bounds are within 1e-9 of each other, relatively, unless the least is much
/// smaller than the largest. Throws InputError ("contacts[i].normal") at a normal of irrational
/// length, and ContractError unless length > 0.
GraspMapMeasures grasp_map_measures(const GraspBox& grasp, const Rational& length = 1);

/// Returns the squared distance of a point, such as the centre of mass, from the centroid of
/// the contacts. Requires a contact.
Rational squared_distance_of_centroid(const GraspBox& grasp, const RationalRow& point);

}  // namespace stickslip
