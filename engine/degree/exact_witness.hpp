// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact equilibria of one grasp in space, or of several bodies, from those in doubles.
#pragma once

#include <optional>

#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// Returns an exact equilibrium with these modes, or nothing if none is found. No contact may
/// slip where friction acts, as the slip's length is irrational in space; if the law is linear
/// they may, and modes may differ a little (equilibrium_in_modes()). The law is that of one
/// grasp.
std::optional<ShareWitness> exact_witness(const GraspLaw& law, const NearEquilibrium& near);

}  // namespace stickslip
