// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The equilibria of a grasp in the plane, in doubles, by its slip states.
#pragma once

#include <vector>

#include "rounded_box.hpp"
#include "stickslip/engine/near_equilibrium.hpp"

namespace stickslip {

/// Returns equilibria of one body in the plane at which it moves, slip state by slip state.
/// Only quadratically many states are consistent with rigid motion (the paper, section 4). An
/// equilibrium at which all contacts press is always found; where contacts open, one in each
/// state at most. Those from which forces turn small motions back, as springs do, come before
/// those of the other orientation, and of each kind the nearest is first. As a load grows, one
/// of each kind meet and are lost; in a box those of the second kind move farther, and they are
/// often all that Newton's method finds. There is no result for other grasps, or for more than
/// kMostContactsOfStates contacts with friction. O(m^3).
std::vector<NearEquilibrium> equilibria_by_states(const RoundedGrasp& grasp);

/// The most contacts with friction for equilibria_by_states().
constexpr std::size_t kMostContactsOfStates = 16;

}  // namespace stickslip
