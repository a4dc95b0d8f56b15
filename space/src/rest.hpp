// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs that every grasp of a box is stable at rest: nothing moves, and friction answers
/// whatever load is left (certificate/FORMAT.md, section 6, "Stable: at rest").
#pragma once

#include <optional>

#include "equilibria.hpp"
#include "stickslip/space/spatial_verdict.hpp"

namespace stickslip::space_detail {

/// A proof about the box (of a margin, for all of its multiples) near an equilibrium of its
/// middle, if that is at rest. Verified exactly by the rules of the format. O(contacts).
std::optional<RestProof> prove_at_rest(const SpaceModel& box, const NearEquilibrium& middle);

}  // namespace stickslip::space_detail
