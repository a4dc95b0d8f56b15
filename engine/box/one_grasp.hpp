// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Single grasps of a box: in the plane as the engine for these knows them, in space by
/// Newton's method.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip::box_detail {

/// The least power of two that is not below a number >= 0; of 0 it is 1.
Rational power_of_two_above(const Rational& size);

/// A number of few bits near (a + b) / 2, between them.
Rational short_middle(const Rational& a, const Rational& b);

/// The problem of a law of one grasp in the plane.
Problem problem_of(const GraspLaw& point);

/// Some equilibria of a law of one grasp, in doubles. `has_enclosures`: of lengths, in so many
/// bits that exact equilibria take longer than a proof without them.
std::vector<NearEquilibrium> near_equilibria(const GraspLaw& point, bool has_enclosures);

/// Whether a motion in doubles, of which the last digits are wrong, may be within the bound.
bool may_be_within(const Law& law, const NearEquilibrium& near);

/// Whether the only grasp of this box is stable; nothing if that is undecided.
std::optional<bool> is_stable(const GraspBox& point, NormalLaw law,
                              const SearchOptions& options = {});

/// Stable or unstable throughout, or undecided; never fragile. The box may be cut into so many
/// parts and one.
BoxDecision prove_box(const GraspBox& box, NormalLaw law, const SearchOptions& options,
                      std::size_t most_parts);

}  // namespace stickslip::box_detail
