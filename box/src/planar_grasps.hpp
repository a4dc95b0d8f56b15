// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Single grasps of a box in the plane, as the engine for these knows them.
#pragma once

#include <vector>

#include "stickslip/box/box_verdict.hpp"
#include "stickslip/degree/newton.hpp"

namespace stickslip::box_detail {

/// The problem of a law of one grasp.
Problem problem_of(const GraspLaw& point);

/// Some of its equilibria, in doubles. `has_enclosures`: of lengths, in so many bits that exact
/// equilibria take longer than a proof without them.
std::vector<NearEquilibrium> near_equilibria(const GraspLaw& point, bool has_enclosures);

/// Stable or unstable throughout, or undecided; never fragile. Irrational lengths are enclosed
/// as the options say.
BoxDecision prove_box(const GraspBox& box, NormalLaw law, const BoxOptions& options,
                      std::size_t most_parts);

}  // namespace stickslip::box_detail
