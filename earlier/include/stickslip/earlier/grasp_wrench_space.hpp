// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The grasp wrench space: the wrenches that the contacts can apply with bounded normal forces
/// and friction in its cones; and the radius of the largest ball about 0 in it.
///
/// For unit normals and c_i = (c_n,i, c_t,i) in its friction cone, the space is
/// { sum c_n,i N_i + c_t,i T_i } under
///
/// - L1: sum c_n,i <= 1, the convex hull of 0 and the edge wrenches N_i +- mu_i T_i;
/// - Linf: c_n,i <= 1 for each i, the Minkowski sum of the triangles 0, N_i +- mu_i T_i.
///
/// Both contain 0. A load w is resisted by forces within the bound iff -w is in the space.
///
/// Forces and torques do not compare: a point here is (f_x, f_y, torque / length), with a
/// characteristic length that the caller chooses. The Ferrari-Canny quality is the radius of
/// the largest ball about 0 inside the space in these coordinates; with facets u.x <= h it is
/// the least h/|u|, an algebraic number whose square is rational.
///
/// Unit normals are needed, so a normal of irrational length throws InputError
/// ("contacts[i].normal"); the remedy is snapping. Preload, stiffness and load play no part.
///
/// In space, where the cones are round, the L1 space is the convex hull of 0 and of the discs
/// N_i + (f, p_i x f), |f| <= mu_i, in six coordinates; its radius is enclosed (wrench_ball).
///
/// Source: Ferrari and Canny, "Planning optimal grasps", ICRA 1992, pp. 2290-2295; Zheng,
/// "An efficient algorithm for a grasp quality measure", IEEE Trans. Robotics 29(2), 2013;
/// Haas-Heger et al., RSS 2018, Sections II, VI and Fig. 7(a).
#pragma once

#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// The bound on the normal forces.
enum class ForceBound { kL1, kLinf };

/// The half-space normal.x <= offset.
struct HalfSpace {
  IntegerVector<3> normal;  ///< primitive, outward
  Rational offset;          ///< >= 0
};

/// Returns the facets of the space, sorted by normal. If the space is flat (no interior), they
/// are the two half-spaces u.x <= 0, -u.x <= 0 of one plane that contains it.
///
/// L1: double description in integers, cubic in the number of facets. Linf: the normal of a
/// facet is orthogonal to two independent edges of the triangles, so O(m^2) normals are tried
/// and O(m) operations spent on each. Throws InputError at a normal of irrational length, and
/// ContractError unless length > 0.
std::vector<HalfSpace> wrench_space_facets(const Problem& problem, ForceBound bound,
                                           const Rational& length = 1);

/// The largest ball about 0 in a grasp wrench space.
struct GraspQuality {
  Rational radius_squared;  ///< 0 iff 0 is on the border, as for every flat space
  HalfSpace nearest;        ///< a facet where the ball touches: offset^2 = radius^2 |normal|^2
};

/// Returns the largest ball. Throws ContractError if `facets` is empty.
GraspQuality ferrari_canny_quality(const std::vector<HalfSpace>& facets);

/// Bounds of the radius of the largest ball about 0 in the L1 space of a grasp in space.
struct WrenchBall {
  Rational low_squared;   ///< a bound for the ball in the hull of finitely many points of the
                          ///< space
  Rational high_squared;  ///< 0 iff 0 is on the border
  Row direction;          ///< u: no u.x in the space is above sqrt(high_squared) |u|
  std::size_t points;     ///< points of the discs in that hull
  std::size_t facets;     ///< facets of the hull
};

/// The limits of the search for a ball.
struct WrenchBallLimits {
  Rational ratio = Rational(99, 100);  ///< the ratio of the bounds at which the search ends
  std::size_t most_facets = 20000;     ///< facets of the hull
};

/// Encloses the ball of a grasp in space without uncertain numbers. A point of the space
/// farthest along the normal of the facet nearest to 0 joins the hull, until that facet and the
/// space are about equally near to 0; so points come where they matter. Each point is one cut
/// of a double description in integers. Throws InputError at a normal of irrational length.
WrenchBall wrench_ball(const GraspBox& grasp, const Rational& length = 1,
                       const WrenchBallLimits& limits = {});

/// Returns the forces of the L1 space with torque 0, a convex polygon: its vertices
/// counterclockwise from the lexicographically least; one or two points if it is degenerate.
/// O(m^2 log m).
std::vector<Vector2> zero_torque_slice(const Problem& problem);

}  // namespace stickslip
