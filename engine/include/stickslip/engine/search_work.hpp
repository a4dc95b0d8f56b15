// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Counters of the work of searches.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// The work of searches, by counters; reproducible.
struct SearchWork {
  std::size_t nodes = 0;         ///< nodes of all other trees, completed or given up
  std::size_t pieces = 0;        ///< nodes of trees whose leaves' twists move
  std::size_t leaves = 0;        ///< leaves that were confirmed
  std::size_t rays = 0;          ///< generators of all regions, lines counted twice
  std::size_t most_rays = 0;     ///< generators of the region that had most
  std::size_t pairs = 0;         ///< pairs of rays tested for being neighbours when a plane cut
  std::size_t ray_bits = 0;      ///< bits of the largest entry of any ray
  std::size_t twist_bits = 0;    ///< bits of the largest entry of a leaf's twist
  std::size_t filter_hits = 0;   ///< twists that doubles judged
  std::size_t exact_checks = 0;  ///< twists that doubles could not judge
  std::size_t proofs = 0;        ///< shapes of proofs by degree that were tried
  std::size_t examples = 0;      ///< grasps of the box decided one by one
  std::size_t parts = 0;         ///< pieces of the box that were tried

  /// Adds the counters of another search; the maxima become the larger ones.
  SearchWork& operator+=(const SearchWork& part);
};

/// Returns the counters with their names, in the order of the members.
std::vector<std::pair<std::string, std::size_t>> counters(const SearchWork& work);

}  // namespace stickslip
