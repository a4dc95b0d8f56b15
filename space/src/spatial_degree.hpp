// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs by degree in space (certificate/FORMAT.md, sections 6 and 7).
#pragma once

#include <optional>
#include <vector>

#include "equilibria.hpp"
#include "stickslip/space/spatial_verdict.hpp"

namespace stickslip::space_detail {

/// Tries to prove that every grasp in the box has an equilibrium, around this one of its
/// middle; `moves` are ways that it goes within the box, any of them at once. No node limit:
/// only what is quick is tried; and nothing once there were `most_nodes` in all.
std::optional<SpatialDegreeProof> prove_stable(const SpaceModel& model,
                                               const SpaceModel& middle,
                                               const NearEquilibrium& equilibrium,
                                               std::size_t node_limit, std::size_t most_nodes,
                                               SearchWork& work,
                                               const std::vector<EigenVector6>& moves = {});

}  // namespace stickslip::space_detail
