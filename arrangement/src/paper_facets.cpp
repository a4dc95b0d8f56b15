// SPDX-License-Identifier: GPL-3.0-or-later
// Step 2 of the paper: all pairs of regions at Hamming distance 1.
#include <optional>

#include "stickslip/arrangement/paper_enumerator.hpp"

namespace stickslip {
namespace {

/// The place where two states differ, if there is exactly one.
std::optional<std::size_t> only_difference(const SlipState& a, const SlipState& b) {
  std::optional<std::size_t> place;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (place) return std::nullopt;
    place = i;
  }
  return place;
}

}  // namespace

std::vector<PaperFacet> paper_facets(const std::vector<SlipState>& regions, PaperWork* work) {
  std::vector<PaperFacet> facets;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    for (std::size_t l = k + 1; l < regions.size(); ++l) {
      if (work != nullptr) ++work->pairs_compared;
      const std::optional<std::size_t> plane = only_difference(regions[k], regions[l]);
      if (!plane) continue;
      facets.push_back({k, l, *plane, regions[k]});
      facets.back().state[*plane] = Sign::kZero;
    }
  }
  return facets;
}

}  // namespace stickslip
