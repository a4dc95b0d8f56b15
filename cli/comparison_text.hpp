// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Evidence of the earlier methods, as JSON and in words.
#pragma once

#include "numbers.hpp"
#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip {

/// "contact 0".
std::string contact_name(std::size_t index);

/// "(1 case refuted)".
std::string cases_refuted(std::size_t count);

/// The force in the object frame.
Vector2 vector_of(const ContactRow& row, const ContactForce& f);

Json forces_json(const Problem& problem, const std::vector<ContactForce>& forces);
Json witness_json(const Problem& problem, const Witness& witness);
Json motion_json(const Twist& d);
Json refutation_json(const Refutation& refutation);

/// "the forces (1, -1/2) at contact 0 and (1, 1/2) at contact 2": two of them, and how many
/// more.
std::string some_forces(const Problem& problem, const std::vector<ContactForce>& forces,
                        NumberText& text);

/// What motion and forces do at the first contact where maximum dissipation forbids it: "lets
/// contact 0 slip without friction, though mu = 1/2". Empty if nowhere.
std::string dissipation_breach(const Problem& problem, const Witness& witness,
                               NumberText& text);

}  // namespace stickslip
