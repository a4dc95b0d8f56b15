// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Equilibria in doubles, where exact ones would be long: proposals, from which proofs start.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip {

/// A motion near that of an equilibrium, and its forces; nothing about it is certain.
struct RoundedEquilibrium {
  /// Of one contact; coefficients as of ContactForce.
  struct Force {
    double normal = 0;      ///< a
    double tangential = 0;  ///< b
    bool still = false;     ///< there is no slip at the contact
  };

  std::array<double, 3> twist{};  ///< x, y, r
  std::vector<Force> forces{};    ///< by ContactId
};

/// An exact one, rounded.
RoundedEquilibrium rounded_equilibrium(const Problem& problem, const Witness& witness);

/// Where Newton's method leads: from rest, and then, unless `starts` is 0, from contacts that
/// press much harder, and from this many motions at random (always the same ones). O(m) for
/// each of a few hundred steps a start, in doubles. Maybe none, also if the grasp is stable;
/// some may be near no equilibrium. Not of a family.
std::vector<RoundedEquilibrium> find_rounded_equilibria(const Problem& problem,
                                                        std::size_t starts);

/// Whether the least common denominator of all numbers of the problem's contacts has more than
/// `bits` bits, and so mostly the numbers of an exact equilibrium. With 2^14 they have tens of
/// thousands of digits, take seconds, and are longer than a proof by degree. O(m) divisions of
/// numbers of so many bits.
bool has_long_equilibria(const Problem& problem, std::size_t bits = std::size_t{1} << 14);

}  // namespace stickslip
