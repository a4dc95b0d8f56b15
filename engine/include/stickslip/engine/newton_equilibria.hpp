// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Finds equilibria in doubles, for grasps whose exact ones would be long. They are proposals
/// from which proofs start.
#pragma once

#include <cstddef>
#include <vector>

#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// Returns an exact equilibrium in doubles, with rotations times `length`, and friction as
/// ContactForce has it.
NearEquilibrium rounded_equilibrium(const Problem& problem, const Witness& witness,
                                    double length);

/// Returns where Newton's method leads: from rest and then, unless `starts` is 0, from contacts
/// that press much harder, and from `starts` random motions, which are always the same. There
/// may be no result although the grasp is stable, and a result may be near no equilibrium.
/// Units are those of rounded_equilibrium(). Requires that the problem is no family. Takes O(m)
/// in doubles for each of a few hundred steps a start.
std::vector<NearEquilibrium> newton_equilibria(const Problem& problem, std::size_t starts,
                                               double length);

/// Returns whether the least common denominator of all numbers of the problem's contacts has
/// more than `bits` bits; mostly the numbers of an exact equilibrium are then as long. With
/// 2^14 bits such numbers have tens of thousands of digits, take seconds, and are longer than a
/// proof by degree. Takes O(m) divisions of numbers of so many bits.
bool has_long_equilibria(const Problem& problem, std::size_t bits = std::size_t{1} << 14);

}  // namespace stickslip
