// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs by degree in space (certificate/FORMAT.md, sections 6 and 7).
#pragma once

#include <optional>

#include "equilibria.hpp"
#include "stickslip/space/spatial_verdict.hpp"

namespace stickslip::space_detail {

/// Tries to prove that every grasp in the box has an equilibrium, around this one of its
/// middle.
std::optional<SpatialDegreeProof> prove_stable(const SpaceModel& model,
                                               const SpaceModel& middle,
                                               const NearEquilibrium& equilibrium,
                                               std::size_t node_limit, SpatialWork& work);

}  // namespace stickslip::space_detail
