// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Treats central planes n.d = 0 in R^3 as great circles on the unit sphere of motions, with
/// coincident and opposite planes merged (Haas-Heger et al., RSS 2018, Section IV.A).
///
/// d has the coordinates (x, y, r) of a Twist. Only the ray of a normal matters here: scaling
/// by a positive number changes nothing, a negative one flips that plane's sign.
#pragma once

#include <vector>

#include "stickslip/core/grasp.hpp"
#include "stickslip/core/ids.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/core/sign.hpp"

namespace stickslip {

/// The distinct great circles of a list of planes. Plane i lies on circle `circle[i]`, and
/// sign(n_i.d) = orientation[i] * sign(normals[circle[i]].d).
struct GreatCircles {
  /// The normals by CircleId: primitive, with the first nonzero entry positive.
  std::vector<IntegerVector3> normals;
  std::vector<CircleId> circle;   ///< the circle of each plane
  std::vector<Sign> orientation;  ///< the orientation of each plane: kPositive or kNegative
  int rank = 0;                   ///< the rank of the normals, 0..3
};

/// Merges equal and opposite planes, in order of first appearance. O(m log m) operations.
/// Throws ContractError if a normal is zero.
GreatCircles merge_planes(const std::vector<Vector3>& plane_normals);

/// Returns the planes T_i.d = 0 on which contacts stick, in the order of the contacts: the
/// coordinates (t_x, t_y, p_x t_y - p_y t_x) of each tangent row, which is never zero.
std::vector<Vector3> stick_planes(const Grasp& grasp);

}  // namespace stickslip
