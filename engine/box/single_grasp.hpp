// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Single grasps of a box: the engine for these decides in the plane, and Newton's method finds
/// equilibria in space.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/engine/near_equilibrium.hpp"

namespace stickslip::box_detail {

/// Returns some equilibria of a law of one grasp, in doubles. `has_enclosures` says that
/// lengths are enclosed, in so many bits that exact equilibria take longer than a proof without
/// them.
std::vector<NearEquilibrium> equilibria_in_doubles(const GraspLaw& point, bool has_enclosures);

/// Returns whether a motion in doubles, whose last digits may be wrong, is beyond a bound on
/// some coordinate. An empty bound is none.
bool is_beyond(const Law& law, const NearEquilibrium& near, const RationalRow& bound);
/// Returns whether a motion in doubles, whose last digits are wrong, may be within the bound.
bool may_be_within(const Law& law, const NearEquilibrium& near);

/// Returns whether the only grasp of this box is stable; nothing if that is undecided.
std::optional<bool> is_stable(const GraspBox& point, NormalLaw law,
                              const SearchOptions& options = {});

/// Returns that the box is stable or unstable throughout, or undecided; never fragile. The box
/// may be cut so many times, into one part more.
BoxDecision prove_box(const GraspBox& box, NormalLaw law, const SearchOptions& options,
                      std::size_t most_parts);

}  // namespace stickslip::box_detail
