// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Equilibria that can be stated in few words.
///
/// A motion implies the force of every contact but those that stick. For these a witness states
/// the shares sigma of their friction that are used, b = sigma mu a, -1 <= sigma <= 1
/// (certificate/FORMAT.md, section 3). Many contacts may stick (all do where nothing moves),
/// and then only balance, three equations, restrains their shares: so there are always shares
/// of which at most three are neither 0 nor 1 nor -1.
///
/// **Method.** The linear program "sum sigma_i mu_i a_i T_i makes up for the other forces,
/// sum |sigma_i| least" has three rows. The dual simplex method for bounded variables with long
/// steps (Maros, "A generalized dual phase-2 simplex algorithm", 2003) solves it in double
/// precision from sigma = 0, in a few steps of O(m log m) each. Its basis is solved exactly; if
/// that is no solution, but nearly, the exact method goes on from there.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/core/sign.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// Returns an equilibrium with the motion d under the problem's one load, or nothing if none is
/// found, as where there is none.
std::optional<Witness> find_forces(const Problem& problem, const Twist& d);

/// Returns an equilibrium with the same motion and normal forces, and friction with few shares.
/// Friction is on the edge that opposes slip where `slips` has a sign, and free where it is
/// zero. Returns nothing if none is found that balances the load.
std::optional<Witness> with_few_shares(const std::vector<ContactRow>& rows, const Wrench& load,
                                       const std::vector<Sign>& slips, Witness witness);

}  // namespace stickslip
