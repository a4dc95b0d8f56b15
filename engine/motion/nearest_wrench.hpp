// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The search for a virtual twist in double precision: the wrench of least norm among the sums
/// that a region allows (Wolfe 1976; Gilbert, Johnson, Keerthi 1988). It only proposes.
#pragma once

#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "nearest_point.hpp"

namespace stickslip {

/// The result of a search: a twist, or a combination of wrenches that vanishes.
template <class Vector, class Support>
struct NearestWrench {
  bool separated = false;  ///< it is a twist
  Vector twist{};          ///< the twist, if it is one: all wrenches are against it
  std::vector<std::pair<double, Support>> parts;  ///< if not, wrenches with weights of sum 1
};

/// Searches from y on. `worst(y)` returns the Support with the most work on y, or nothing if
/// there is none; its member `wrench` does the work `work` on y. A Vector is a Double3 or
/// Reals, or another std::array. `deep` asks that wrenches are against the twist with some to
/// spare, so that it may be rounded.
template <class Vector, class Worst>
auto nearest_wrench(Vector y, const Worst& worst, bool deep = false) {
  using Support = typename decltype(worst(y))::value_type;
  constexpr std::size_t kMostSteps = 100;
  constexpr double kVanishing = 1e-22;  // part of squared lengths; a proposal, not a decision
  NearestWrench<Vector, Support> result;
  std::vector<Support> supports;
  NearestPointOf<Vector> hull;
  double largest = 0;
  if (dot(y, y) == 0) y[0] = 1;
  for (std::size_t step = 0; step < kMostSteps; ++step) {
    std::optional<Support> support = worst(y);
    if (!support) break;
    // No wrench does more work on minus the nearest point than minus that point's square; half
    // of that will do.
    constexpr double kDeep = 0.5;
    if (support->work < 0) {
      result.separated = true;
      result.twist = y;
      if (!deep || (step > 0 && support->work <= -kDeep * dot(y, y))) return result;
    }
    const Vector wrench = support->wrench;
    supports.push_back(std::move(*support));
    largest = std::max(largest, dot(wrench, wrench));
    const bool progress = hull.add(wrench);
    const Vector& nearest = hull.nearest();
    if (!progress || dot(nearest, nearest) <= kVanishing * largest) break;
    y = nearest;
    for (double& entry : y) entry = -entry;
  }
  if (result.separated) return result;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    result.parts.emplace_back(hull.weight(k), std::move(supports[hull.order(k)]));
  }
  return result;
}

/// Returns the first vector that is accepted of those near a multiple of `y`, in more and more
/// bits.
template <class Vector, class Accept>
auto in_fewest_bits(const Vector& y, std::initializer_list<int> bits, const Accept& accept)
    -> std::optional<decltype(in_bits(y, 0))> {
  decltype(in_bits(y, 0)) before{};
  for (const int count : bits) {
    auto candidate = in_bits(y, count);
    if (candidate == before || is_zero(candidate)) continue;
    if (accept(candidate)) return candidate;
    before = std::move(candidate);
  }
  return std::nullopt;
}

}  // namespace stickslip
