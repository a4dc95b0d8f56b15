// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The engines' verdicts, with the evidence judged each time.
#pragma once

#include <string>

#include "check_refutation.hpp"
#include "random_grasps.hpp"
#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/engine/states_engine.hpp"

namespace stickslip::test {

/// "stable" or "unstable" by decide_by_states and branch_and_bound. Fails the running test if
/// they differ, a witness is not an equilibrium or has more shares of friction than it needs, a
/// refutation does not hold (check_refutation), or the work does not add up.
std::string judged_verdict(const LoadCase& load_case, RaysFrom rays_from = RaysFrom::kRegion);

/// The same for both normal laws: "stable", "unstable", or "unilateral stable, bilateral
/// unstable". The other way round there is no equilibrium to be found: bilateral equilibria are
/// unilateral ones, so that fails the test.
std::string judged_verdicts(const LoadedGrasp& loaded);

}  // namespace stickslip::test
