// SPDX-License-Identifier: GPL-3.0-or-later
#include "margin_degree.hpp"

#include <algorithm>
#include <utility>

namespace stickslip::margin_detail {
namespace {

/// Returns a multiple in few bits.
Rational short_multiple(double value) {
  constexpr int kBits = 6;
  return rational_in_bits(value, kBits);
}

}  // namespace

std::vector<MarginSegment> DegreeChain::find() {
  std::vector<MarginSegment> found;
  const double before = search_.force_of(1, 0);
  const double growth = search_.force_of(0, 1);
  if (!search_.is_possible()) return found;
  if (before == 0) {
    // Without any other load all multiples above 0 have one verdict.
    const std::optional<Motion> at = search_.settle(1, 1, nullptr);
    auto proof = at ? search_.prove_segment({1, {}}, *at, *at, true) : std::nullopt;
    if (proof) found.push_back({0, {}, {}, {}, std::move(proof)});
    return found;
  }
  // At this multiple the growing load is as large as the load before.
  const double typical = before / growth;
  Rational low = 0;
  // More may be resisted beyond a multiple for which no proof is found.
  for (const double leap : {0.0, 0.06, 0.25, 1.0}) {
    if (leap > 0) low += short_multiple(leap * typical);
    extend(low, typical, found);
    if (found.empty() || found.back().low < low) continue;
    if (!found.back().high) break;
    low = *found.back().high;
  }
  return found;
}

/// Appends segments from `low` upwards as far as they go.
void DegreeChain::extend(const Rational& low, double typical,
                         std::vector<MarginSegment>& found) {
  std::optional<Motion> at = search_.settle(1, to_double(low), nullptr);
  if (!at) return;
  double step = typical / 4;
  Rational here = low;
  constexpr double kSmallest = 1.0 / 256;  // an exact equilibrium is worth as much
  constexpr double kLargest = 1e6;
  double next_ray = typical / 4;
  bool grows = true;  // a step that has failed seldom serves a little farther on
  while (step > kSmallest * std::max(typical, to_double(here)) &&
         to_double(here) < kLargest * typical) {
    const double multiple = to_double(here);
    if (multiple >= next_ray) {
      next_ray = 2 * multiple;
      // Friction may have no smooth way to the ray itself; then a motion near it will do.
      constexpr double kNearRay = 1e-3;
      auto end = search_.settle(0, multiple, &*at);
      if (!end) end = search_.settle(kNearRay, multiple, &*at);
      if (end) {
        if (auto proof = search_.prove_segment({here, {}}, *at, *end, false)) {
          found.push_back({here, {}, {}, {}, std::move(proof)});
          return;
        }
      }
    }
    const Rational next = here + short_multiple(step);
    const auto end = search_.settle(1, to_double(next), &*at);
    auto proof = end ? search_.prove_segment({here, next}, *at, *end, step <= typical / 16)
                     : std::nullopt;
    if (!proof) {
      step /= 2;
      grows = false;
      continue;
    }
    found.push_back({here, {}, next, {}, std::move(proof)});
    here = next;
    at = end;
    if (grows) step *= 2;
    grows = true;
  }
}

}  // namespace stickslip::margin_detail
