// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The system of one region of one grasp in the plane as an exact linear program
/// (engine/search/relaxed_region.hpp), and what its points say of the grasp.
#pragma once

#include <optional>
#include <variant>

#include "engine/search/relaxed_region.hpp"
#include "region.hpp"

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
