// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The regions and leaf rules of certificate/FORMAT.md, section 4, as the text states them:
/// lists of linear functions, values by substitution, no tight sets and no shortcuts. The twin
/// of Cone and Region.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/engine/verdict.hpp"

namespace stickslip::test {

using Rays = std::vector<Vector5>;

Rational value_at(const Vector5& function, const Vector5& x);
Vector5 to_rational(const IntegerVector5& x);

/// function >= 0, = 0 or <= 0, for sign = 1, 0, -1.
struct Constraint {
  Vector5 function;
  int sign;

  bool holds_at(const Vector5& x) const;
};

/// Vectors that generate { x : every constraint holds }: a basis of its largest linear
/// subspace, and one ray for each extreme ray modulo that.
struct Generators {
  Rays lines;
  Rays rays;

  /// A line counts as two rays.
  Rays directions() const;
};

/// By trying all sets of planes that could meet in a ray. O(n^3) sets for n constraints.
Generators brute_force_generators(const std::vector<Constraint>& constraints);

std::size_t rank_of(Rays vectors);

struct NaiveRegion {
  std::vector<Constraint> constraints;
  std::vector<Vector5> strict;
  std::vector<std::optional<int>> labels;  ///< +1, 0, -1

  static NaiveRegion root(const Problem& problem);
  NaiveRegion slip_child(const Problem& problem, std::size_t contact, int slip) const;
  NaiveRegion separation_child(const Problem& problem, std::size_t contact, bool closed) const;
  NaiveRegion plane_child(const Vector5& plane, bool first) const;
};

// In what follows `rays` generate the region.

bool naive_is_barred(const NaiveRegion& region, const Rays& rays);

/// +1, -1, or nothing. Where a region is barred as a whole both signs may be said to hold;
/// this says +1.
std::optional<int> naive_sign(const Problem& problem, const NaiveRegion& region,
                              const Rays& rays, std::size_t contact);

/// g(r) for each ray.
std::vector<Rational> naive_bounds(const Problem& problem, const NaiveRegion& region,
                                   const Rays& rays, const TwistLeaf& leaf);

bool naive_refutes(const Problem& problem, const NaiveRegion& region, const Rays& rays,
                   const TwistLeaf& leaf);

}  // namespace stickslip::test
