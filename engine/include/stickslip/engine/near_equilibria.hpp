// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Equilibria in doubles, where exact ones would be long: proposals, from which proofs start.
#pragma once

#include <cstddef>
#include <vector>

#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// An exact one, rounded, with rotations times `length`; friction as ContactForce has it.
NearEquilibrium near_equilibrium(const Problem& problem, const Witness& witness, double length);

/// Where Newton's method leads: from rest, and then, unless `starts` is 0, from contacts that
/// press much harder, and from this many motions at random (always the same ones). O(m) for
/// each of a few hundred steps a start, in doubles. Maybe none, also if the grasp is stable;
/// some may be near no equilibrium. Not of a family. Units as above.
std::vector<NearEquilibrium> near_equilibria(const Problem& problem, std::size_t starts,
                                             double length);

/// Whether the least common denominator of all numbers of the problem's contacts has more than
/// `bits` bits, and so mostly the numbers of an exact equilibrium. With 2^14 they have tens of
/// thousands of digits, take seconds, and are longer than a proof by degree. O(m) divisions of
/// numbers of so many bits.
bool has_long_equilibria(const Problem& problem, std::size_t bits = std::size_t{1} << 14);

}  // namespace stickslip
