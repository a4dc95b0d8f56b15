// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Sums and conditions of contact forces, shared by the earlier methods.
#pragma once

#include <vector>

#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip::earlier_detail {

/// The load and all contact wrenches together: 0 in balance.
Wrench resultant(const Problem& problem, const std::vector<ContactForce>& forces);

/// a >= 0 and |b| <= mu a.
bool is_in_cone(const ContactRow& row, const ContactForce& force);

/// True if the forces lie in their friction cones and balance the load.
bool balances_in_cones(const Problem& problem, const std::vector<ContactForce>& forces);

/// The force with the coefficients plus and minus (>= 0) on the edges N + mu T and N - mu T.
ContactForce force_of_edges(const ContactRow& row, const Rational& plus, const Rational& minus);

}  // namespace stickslip::earlier_detail
