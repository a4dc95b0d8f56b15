// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Three more measures that people rank grasps by, of the wrenches and the forces of contacts
/// whose friction is in Coulomb's cones: the volume of the wrench space, the least normal
/// forces that hold a load, and the margin of internal forces. Stiffnesses and preloads play no
/// part.
///
/// - The *volume* is that of the convex hull of 0 and of all wrenches of unit normal forces
///   with friction, with torques divided by a length L; its measure is force^2 torque/L in the
///   plane, and force^3 (torque/L)^3 in space.
/// - The *least normal forces* are the least sum of the normal forces in the cones that balance
///   a load, or the least number that none of such normal forces exceeds. For a twist z, h_i =
///   max(0, mu |z.T_i| - z.N_i) is the most work against z of a unit normal force of contact i;
///   so z.w <= sum of l_n,i h_i, and the sum is at least z.w / max h_i, and the largest at
///   least z.w / sum h_i.
/// - The *margin of internal forces* is the largest d such that forces which balance the load
///   are at a distance of at least d from breaking a condition (robustness.hpp), the numerator
///   of PCR. A contact without friction has no condition of friction.
///
/// In the plane the volume and the least forces are exact. In space, and of margins, there are
/// two bounds. With pyramids in place of cones (robustness.hpp) all but margins are exact.
///
/// Sources: Miller and Allen, "Examples of 3D grasp quality computations", ICRA 1999; Han,
/// Trinkle and Li, "Grasp analysis as linear matrix inequality problems", IEEE Trans. Robotics
/// and Automation 16(6), 2000; Kerr and Roth, "Analysis of multifingered hands", Int. J.
/// Robotics Research 4(4), 1986; they are collected in Roa and Suarez, "Grasp quality measures:
/// review and performance", Autonomous Robots 38(1), 2015. The volume is a sum over simplices:
/// Cohen and Hickey, "Two algorithms for determining volumes of convex polyhedra", J. ACM
/// 26(3), 1979.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/earlier/grasp_wrench_space.hpp"
#include "stickslip/earlier/robustness.hpp"

namespace stickslip {

/// The convex hull of points, enclosed by two volumes.
struct HullVolume {
  Rational lower;  ///< at most the volume
  Rational upper;  ///< at least the volume
};

/// Returns the volume of the convex hull of 0 and points of as many coordinates each, exactly;
/// nothing if a hull on the way has more than so many facets. Double description in integers,
/// and one determinant for each simplex of a triangulation.
std::optional<Rational> hull_volume(const std::vector<RationalRow>& points,
                                    std::size_t most_facets);

/// Returns the volume of the wrench space of one grasp, without uncertain numbers and of one
/// body, and nothing as hull_volume() does. In space it is between those of hulls with polygons
/// of eight corners inside the discs of friction, and around them; or it is that of pyramids
/// with so many edges. Throws InputError
/// ("contacts[i].normal") at a normal of irrational length, and ContractError unless length >
/// 0.
std::optional<HullVolume> wrench_space_volume(const GraspBox& grasp, const Rational& length,
                                              std::size_t most_facets, std::size_t edges = 0);

/// The least normal forces, between two bounds.
struct LeastForce {
  bool balances = true;               ///< false if it is proved that no forces balance the load
  Rational lower{0};                  ///< at most the least
  std::optional<Rational> upper{};    ///< at least the least; nothing if no forces are known
  std::vector<RationalRow> forces{};  ///< on the object, by ContactId; they show `upper`
  RationalRow twist{};                ///< z, which shows `lower`, or that no forces balance
};

/// Returns the least sum of normal forces that balance the load (kL1), or the least number that
/// none exceeds (kLinf), of one grasp as above. Exact linear programs, in space with more and
/// more directions of friction unless there are pyramids. Throws InputError
/// ("contacts[i].normal") at a normal of irrational length.
LeastForce least_force(const GraspBox& grasp, ForceBound bound, std::size_t edges = 0);

/// The margin of internal forces, between two bounds.
struct InternalMargin {
  bool balances = true;               ///< false if it is proved that no bounded forces do
  Rational lower{0};                  ///< at most the margin
  Rational upper{0};                  ///< at least the margin
  std::vector<RationalRow> forces{};  ///< on the object, by ContactId; they show `lower`
  RationalRow twist{};                ///< shows `upper`, or that no forces balance
};

/// Returns the margin of one grasp as above, with the largest forces of `options`. Throws
/// InputError ("contacts[i].normal") at a normal of irrational length.
InternalMargin internal_margin(const GraspBox& grasp, const RobustnessOptions& options = {});

}  // namespace stickslip
