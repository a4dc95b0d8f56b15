// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The classes of loads under rigid contacts (load_classes.hpp) in space, with Coulomb's own
/// friction cone.
///
/// The rows of a contact are those of certificate/FORMAT.md, section 7: N = (n, p x n), and S a,
/// its slip under the acceleration a. A contact force is a_i N_i + (f_i, p_i x f_i), f_i.n_i = 0.
/// The model is that of the plane with the laws of friction
///
///     |f_i| <= mu_i |n_i| a_i,     f_i = -mu_i |n_i| a_i s / |s|  if s = S_i a != 0.
///
/// **How it is decided.** Discs of friction are put between polygons, and what the plane asks of
/// edges is asked of their corners, by exact programs: forces in an inner polygon are in the cone,
/// and a twist that no force of an outer polygon opposes is opposed by none in the cone. Polygons
/// are refined where the programs' answers are. Slip is split into sectors of directions: friction
/// is against a slip in the sector. What lies on a border whose numbers are irrational, or is
/// nearer to one than the polygons, is undecided.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/equilibrium/question.hpp"
#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip {

/// Mass distribution in space, with mass 1; no class depends on the mass.
struct SpatialInertia {
  Vector3 centre{};  ///< of mass, in the object frame
  /// The tensor of inertia about `centre`, over the mass; symmetric, positive definite.
  std::array<Vector3, 3> gyration{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  /// About the origin, with this radius of gyration about every axis; > 0.
  static SpatialInertia of_length(const Rational& radius) {
    const Rational square = radius * radius;
    return {{}, {{{square, 0, 0}, {0, square, 0}, {0, 0, square}}}};
  }
};

/// M a, the wrench about the origin that gives the acceleration a (of the origin, and angular).
Vector6 times_mass(const SpatialInertia& inertia, const Vector6& a);
/// With its numbers, to be finished.
Json inertia_json(const SpatialInertia& inertia);
/// The centre x, y, z and xx, yy, zz of the tensor, and then xy, xz, yz if they are not 0. Throws
/// InputError with that place unless there are 6 or 9 and the tensor is positive definite.
SpatialInertia spatial_inertia_of(const std::string& place,
                                  const std::vector<Rational>& numbers);

/// The numbers of an option, of one of the two inertias; none if it is empty. Throws InputError
/// ("--inertia") unless they are of either.
RationalRow inertia_numbers(const std::string& value);

/// The one grasp in space that the question is about. Throws InputError if numbers are uncertain.
const GraspBox& point_in_space(const Question& question);

/// What one contact exerts on the object: a N + (f, p x f).
struct SpatialContactForce {
  Rational normal{0};  ///< a >= 0, the force over |n|
  Vector3 friction{};  ///< f, orthogonal to n
};
/// By ContactId.
using SpatialForces = std::vector<SpatialContactForce>;

/// As UnopposedMotion, in space; coprime integers.
struct SpatialUnopposedMotion {
  Vector6 twist;  ///< translation and rotation
};

/// Whether forces in the cones balance the load; undecided within a billionth of the border, unless
/// it is found to be on it.
using SpatialLoadClass = std::variant<SpatialForces, SpatialUnopposedMotion, Undecided>;
/// Evidence checked by substitution. Stiffness and preloads play no part. Requires a point in
/// space.
SpatialLoadClass weakly_stable_load(const GraspBox& grasp);

/// A cell of solutions in parts: touching or apart, as RigidSplit; or with a direction d, the slip
/// of this contact in the quarters between d, n x d, -d, -n x d, after the first of which it is
/// 0; or, in a sector that is known, before d and after it.
struct SpatialSplit {
  ContactId contact{0};                 ///< whose
  std::optional<Vector3> direction{};  ///< d, in the tangent plane, not 0
};
/// As RigidLeaf; h is a vector of the tangent plane with h.s >= 0 for all s of the sector.
struct SpatialLeaf {
  Rational weight;                                        ///< of w
  Vector6 twist;                                          ///< y
  std::vector<std::pair<ContactId, Rational>> normal{};   ///< g, where not 0
  std::vector<std::pair<ContactId, Vector3>> tangent{};   ///< h, where not 0
};
/// A node of a tree in preorder.
using SpatialNode = std::variant<SpatialSplit, SpatialLeaf>;

/// The load accelerates nothing.
struct SpatialStronglyStable {
  SpatialForces rest;               ///< forces at rest
  std::vector<SpatialNode> tree{};  ///< no solution has w.a > 0
};
/// The model allows both rest and motion.
struct SpatialOpenLoad {
  SpatialForces rest;    ///< forces at rest
  Vector6 acceleration;  ///< not 0: of the origin, and angular
  SpatialForces forces;  ///< with it
};

/// *Must move*, *must hold*, *open*, each with its evidence.
using SpatialRigidVerdict = std::variant<SpatialUnopposedMotion, SpatialStronglyStable,
                                         SpatialOpenLoad, Undecided>;

/// Linear programs after which a class in space is undecided.
inline constexpr std::size_t kMostSpatialPrograms = 4000;

/// The class of the load. Evidence checked by substitution. Requires a point in space.
SpatialRigidVerdict rigid_verdict(const GraspBox& grasp, const SpatialInertia& inertia = {},
                                  std::size_t most_programs = kMostSpatialPrograms);

/// "must move", "must hold", "open" or "undecided".
std::string name_of(const SpatialRigidVerdict& verdict);

}  // namespace stickslip
