// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The contact forces of an equilibrium in space, or of several bodies, by the laws of
/// certificate/FORMAT.md, section 1. For bodies in the plane the third coordinates of vectors
/// are 0.
#pragma once

#include <utility>
#include <vector>

#include "stickslip/core/grasp_file.hpp"

namespace stickslip {

/// Returns u + omega x p, by which the motion d = (u, omega) moves the point p of the object.
Vector3 displacement(const Vector3& point, const RationalRow& d);

/// The slip and the forces of one contact in an equilibrium.
struct SpatialForce {
  Rational normal{0};  ///< a >= 0: the normal force is a n; 0 where the contact is open
  Vector3 slip{};      ///< the slip of the object along the tangent plane; 0 where it sticks
  Vector3 friction{};  ///< the friction force, orthogonal to n
  Vector3 force{};     ///< the whole force a n + friction on the object
  Rational spin{0};    ///< n.omega with torsion: how the object turns about n
  Rational moment{0};  ///< the factor of n in the moment of friction with torsion
};

/// Returns the forces, by contact, that follow from the motion d, or the state, of an
/// equilibrium. Contacts that stick have these shares sigma of friction, mu a sigma, or none;
/// the others oppose their slip. Requires that no number of the grasp is uncertain and that all
/// lengths that matter are rational: those of normals where there is a preload, and of slips
/// where there is friction.
std::vector<SpatialForce> forces_of(
    const GraspBox& grasp, const RationalRow& d,
    const std::vector<std::pair<ContactId, RationalRow>>& shares);

/// Returns a force or slip with as many coordinates as points of the grasp have.
RationalRow vector_in(const GraspBox& grasp, const Vector3& v);

/// Returns whether some contact has torsion.
bool has_torsion(const GraspBox& grasp);

/// Returns the moment of friction on the body about the normal of a contact with torsion.
RationalRow moment_of(const SpatialForce& force, const UncertainContact& contact);

/// Returns for each spring of several bodies its torque, tension or force of a ratchet at a
/// state.
std::vector<Rational> spring_forces_of(const GraspBox& grasp, const RationalRow& z);

}  // namespace stickslip
