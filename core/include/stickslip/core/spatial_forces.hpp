// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The contact forces of an equilibrium in space, or of several bodies, by the laws of
/// certificate/FORMAT.md, section 1. Of bodies in the plane the third coordinates
/// of vectors are 0.
#pragma once

#include <utility>
#include <vector>

#include "stickslip/core/grasp_file.hpp"

namespace stickslip {

/// How the motion d = (u, omega) moves the point p of the object: u + omega x p.
Vector3 displacement(const Vector3& point, const RationalRow& d);

/// What one contact does in an equilibrium.
struct SpatialForce {
  Rational normal{0};  ///< a >= 0: the normal force is a n; 0 where the contact is open
  Vector3 slip{};      ///< of the object along the tangent plane; 0 where it sticks
  Vector3 friction{};  ///< orthogonal to n
  Vector3 force{};     ///< a n + friction, on the object
  Rational spin{0};    ///< of a contact with torsion: n.omega, how the object turns about n
  Rational moment{0};  ///< of a contact with torsion: that of friction is moment n
};

/// The forces, by contact, that follow from the motion d, or the state, of an equilibrium.
/// Contacts that stick have these shares sigma of friction, mu a sigma, or none; the others
/// oppose their slip. Requires that no number of the grasp is uncertain, and that all lengths
/// which matter are rational: of normals where there is a preload, of slips where there is
/// friction.
std::vector<SpatialForce> forces_of(
    const GraspBox& grasp, const RationalRow& d,
    const std::vector<std::pair<ContactId, RationalRow>>& shares);

/// Whether some contact has torsion.
bool has_torsion(const GraspBox& grasp);

/// The moment of friction about the normal of a contact with torsion, on the body.
RationalRow moment_of(const SpatialForce& force, const UncertainContact& contact);

/// Of several bodies, by spring: the torques, tensions and forces of ratchets at a state.
std::vector<Rational> spring_forces_of(const GraspBox& grasp, const RationalRow& z);

}  // namespace stickslip
