// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The system of one region as a linear program: Haas-Heger et al. 2018, Eqs. 1, 2, 4 and
/// 12-14, with detaching contacts.
///
/// A point of the region is x = sum lambda_r r over its generators, lambda >= 0, h = 1. A
/// contact that is closed has a_i = v_i(x), linear in lambda; an open one has a_i = 0. A mixed
/// one is relaxed to 0 <= a_i <= sum lambda_r max(0, v_i(r)). Friction is on an edge where slip
/// has a sign, else anywhere in the cone. With nothing mixed the program is exact.
///
/// **Method.** On each ray the relaxed wrenches are a zonotope, with a corner for every choice
/// of edges. The program asks for a combination of such corners with wrench 0 and h = 1: four
/// rows, and columns made only when needed (Dantzig and Wolfe 1960). When the columns at hand
/// do not suffice, the Farkas vector's part on the balance is a virtual twist y, and the corner
/// of each ray that does the most work on y is the only one to try: sigma_i = sign y.T_i. If
/// none of them would help, y satisfies leaf-bound (certificate/FORMAT.md). With an objective,
/// the optimal dual takes the Farkas vector's place. A strict end of a family's range asks for
/// l - low h > 0: that takes the place of h in the fourth row. Every round adds a corner that
/// was not there, so the rounds end; in practice after a few tens. Each costs O(m) rational
/// operations and three per ray for a contact that changes edge.
#pragma once

#include <optional>
#include <variant>

#include "region.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

/// A point of the relaxation; an equilibrium iff nothing is broken.
struct RelaxedPoint {
  Witness witness;        ///< motion and forces
  Rational multiple = 0;  ///< the multiple, in a family
  bool is_ray = false;    ///< h = 0: it may be added to a solution without end
  /// The split at the contact that breaks its normal law (a_i > max(0, v_i)) or maximum
  /// dissipation with the most energy, if any does.
  std::optional<ContactSplit> broken;
  std::optional<SeparationSplit> broken_separation;  ///< the same for the normal laws alone
};

/// Returns a point of the relaxed system, for one of the problem's multiples, or a leaf that
/// refutes the region (verified): `guess` if it does. If it does not, the first columns are
/// made for its twist.
std::variant<RelaxedPoint, TwistLeaf> solve_region(const Problem& problem, const Region& region,
                                                   LpWork* work,
                                                   const TwistLeaf* guess = nullptr);

/// A generator of a region's points, and the load there.
struct LoadedGenerator {
  Vector5 x;     ///< d, h, l
  Vector3 load;  ///< the load that acts there
  /// The values here of functions, at least one, that are nowhere negative on the region and
  /// positive at solutions; h > 0 has to follow from the others, or be one of them.
  std::vector<Rational> positive;
};

/// Returns the same for loads that are no family's, those of these generators, and a region
/// that is known by them and by the signs that slips have on it (Region::slip_sign). The leaf
/// is primitive and not verified; the bounds of FORMAT.md's g on the generators are <= 0, and 0
/// only where one of the positive functions is.
std::variant<RelaxedPoint, TwistLeaf> solve_loaded_region(
    const Problem& problem, const std::vector<std::optional<Sign>>& slips,
    const std::vector<LoadedGenerator>& generators);

/// The smallest and the largest multiple of the relaxed system; `highest` is a ray if there is
/// no largest.
struct MultipleExtent {
  RelaxedPoint lowest;   ///< the point at the smallest multiple
  RelaxedPoint highest;  ///< the point at the largest, or a ray
};

/// Returns the extent over all multiples between the ends of a family's range; nothing if the
/// system has no solution there.
std::optional<MultipleExtent> multiple_extent(const Problem& problem, const Region& region);

}  // namespace stickslip
