// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Convex cones in Q^n by generators alone, with no attempt to find the extreme ones: enough
/// where the generators are few and the result lies in a plane, where its extreme points are
/// easily told (plane_cell.hpp).
#pragma once

#include <utility>
#include <vector>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip::resistance_detail {

/// What a cut keeps: f >= 0, or f = 0.
enum class Keep { kHalfSpace, kPlane };

/// Generators of cone(generators) with f >= 0 or f = 0: those that satisfy it, and for every
/// two on either side the point between them on the plane (Motzkin et al., 1953, without the
/// adjacency test). All primitive. O(n^2) for n generators.
template <std::size_t n>
std::vector<IntegerVector<n>> cut(const std::vector<IntegerVector<n>>& generators,
                                  const IntegerVector<n>& f, Keep keep) {
  std::vector<IntegerVector<n>> kept;
  std::vector<std::pair<Integer, const IntegerVector<n>*>> above;
  std::vector<std::pair<Integer, const IntegerVector<n>*>> below;
  for (const IntegerVector<n>& g : generators) {
    Integer value = dot(f, g);
    if (value.is_zero() || (keep == Keep::kHalfSpace && value.sign() > 0)) kept.push_back(g);
    if (!value.is_zero()) (value.sign() > 0 ? above : below).emplace_back(std::move(value), &g);
  }
  for (const auto& [high, a] : above) {
    for (const auto& [low, b] : below) {
      IntegerVector<n> between;
      for (std::size_t j = 0; j < n; ++j) between[j] = high * (*b)[j] - low * (*a)[j];
      kept.push_back(primitive(std::move(between)));
    }
  }
  return kept;
}

}  // namespace stickslip::resistance_detail
