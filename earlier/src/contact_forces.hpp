// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Sums and conditions of contact forces, shared by the earlier methods.
#pragma once

#include <vector>

#include "stickslip/earlier/load_classes.hpp"

namespace stickslip::earlier_detail {

/// Returns the load and all contact wrenches together: 0 in balance.
Wrench resultant(const Problem& problem, const std::vector<ContactForce>& forces);

/// Returns true if a >= 0 and |b| <= mu a.
bool is_in_cone(const ContactRow& row, const ContactForce& force);

/// Returns true if the forces lie in their friction cones and balance the load.
bool balances_in_cones(const Problem& problem, const std::vector<ContactForce>& forces);

/// Returns the force with the coefficients plus and minus (>= 0) on the edges N + mu T and N -
/// mu T.
ContactForce force_of_edges(const ContactRow& row, const Rational& plus, const Rational& minus);

/// \{ Convert forces to those of the classes of loads, and back.
RigidForces rigid_forces(const std::vector<ContactForce>& forces);
std::vector<ContactForce> planar_forces(const RigidForces& forces);
/// \}

/// \{ Convert a motion in the plane to a row, and back.
RationalRow row_of(const Twist& motion);
Twist planar_motion(const RationalRow& row);
/// \}

/// Requires an inertia of the plane with a radius of gyration above 0.
void require_planar(const Inertia& inertia);

}  // namespace stickslip::earlier_detail
