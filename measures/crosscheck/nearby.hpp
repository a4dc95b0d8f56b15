// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact equilibria beside claimed ones.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/measures/claim.hpp"

namespace stickslip::crosscheck_detail {

/// Returns ClaimReport::claimed_slip of this motion.
std::vector<Sign> slip_of(const GraspBox& grasp, const RationalRow& twist);

/// Returns true if the claimed motion and forces, whose residuals these are, are an
/// equilibrium.
bool is_equilibrium(const ClaimResiduals& residuals);

/// Returns the claim, which is an equilibrium, as a verdict in space; nothing unless lengths of
/// normals are rational where they matter.
std::optional<Stable> verdict_by(const Question& question, const Claim& claim);

/// Returns an equilibrium with the modes that the claim suggests or, if none is found, that of
/// the answer, which is Stable; nothing if that states none, either. `grasp` is that of the
/// answer. A claim that is an equilibrium is its own. Requires a claimed twist or forces.
std::optional<NearbyEquilibrium> nearby_equilibrium(const GraspBox& grasp, const Answer& answer,
                                                    const Claim& claim, bool is_its_own);

}  // namespace stickslip::crosscheck_detail
