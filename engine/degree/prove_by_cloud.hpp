// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs by degree for boxes whose equilibria move far: walls around a cloud of equilibria of
/// grasps of the box, with leaves whose twists move.
#pragma once

#include <optional>

#include "degree_subject.hpp"
#include "newton.hpp"
#include "stickslip/engine/proof.hpp"
#include "stickslip/engine/search_work.hpp"

namespace stickslip::degree_detail {

/// Tries a proof for a box around an equilibrium of its middle. If geometry is uncertain there
/// is room around the cloud, so that what slips there slips one way; a wall that is not refuted
/// moves to where doubles see a reason at the point at which it failed. Else the walls are
/// close to a cloud of more places.
std::optional<DegreeProof> prove_by_cloud(const DegreeSubject& about,
                                          const NearEquilibrium& near, SearchWork& work);

}  // namespace stickslip::degree_detail
