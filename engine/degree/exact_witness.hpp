// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Equilibria of one grasp in space in exact numbers, from those in doubles.
#pragma once

#include <optional>

#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// An exact equilibrium with these modes, if there is one: none may slip where friction acts.
/// The law is that of one grasp.
std::optional<ShareWitness> exact_witness(const GraspLaw& law, const NearEquilibrium& near);

}  // namespace stickslip
