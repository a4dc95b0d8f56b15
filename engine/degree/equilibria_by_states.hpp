// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The equilibria of a grasp in the plane, in doubles, by its slip states.
#pragma once

#include <vector>

#include "newton.hpp"

namespace stickslip {

/// Returns equilibria of one body in the plane at which it moves, slip state by slip state.
/// Only quadratically many states are consistent with rigid motion (the paper, section 4).
/// Those of a state at which no contact opens are all found, and of others one at most. An
/// equilibrium from which forces turn small motions back, as springs do, comes before those of
/// the other orientation, and of each kind the nearest is first. Newton's method finds some of
/// either kind; but the two meet as a load grows, and around the second kind equilibria of a
/// box move far. There is no result for other grasps, or for more than kMostContactsOfStates
/// contacts with friction. O(m^3).
std::vector<NearEquilibrium> equilibria_by_states(const RoundedGrasp& grasp);

/// The most contacts with friction for equilibria_by_states().
constexpr std::size_t kMostContactsOfStates = 16;

}  // namespace stickslip
