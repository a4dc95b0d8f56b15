// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs by degree: a parallelepiped of motions on whose walls no grasp of a box has an
/// equilibrium, and on which the grasp in the middle pulls back (certificate/FORMAT.md,
/// section 6).
#pragma once

#include <optional>

#include "stickslip/box/box_verdict.hpp"
#include "stickslip/equilibrium/search/rounded_equilibrium.hpp"

namespace stickslip::box_detail {

/// The problem of a box of one point.
Problem problem_at(const ParameterBox& point);

/// Tries to prove that every grasp in the box is stable, around this equilibrium of its middle.
/// Adds to `work`.
std::optional<DegreeProof> prove_stable(const ParameterBox& box,
                                        const RoundedEquilibrium& middle,
                                        std::size_t node_limit, SearchWork& work);

/// The same around equilibria in doubles, wherever Newton's method leads in the middle.
std::optional<DegreeProof> prove_stable_by_degree(const ParameterBox& box,
                                                  std::size_t node_limit, SearchWork& work);

}  // namespace stickslip::box_detail
