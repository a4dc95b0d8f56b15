// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What searches may take, and what they took.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/engine/part.hpp"

namespace stickslip {

/// How much to try.
struct SearchOptions {
  /// Of each tree search; 0: one that suits most questions, and in space takes about a minute
  /// at most for 12 contacts.
  std::size_t node_limit = 0;
  /// Of the enclosure of irrational lengths; in the plane doubled from this until there is an
  /// answer, to the limit.
  unsigned bits = kDefaultBits;
  unsigned most_bits = 1024;  ///< the limit
};

/// Reproducible.
struct SearchWork {
  std::size_t nodes = 0;         ///< of all trees, whether they were completed or given up
  std::size_t leaves = 0;        ///< that were confirmed
  std::size_t rays = 0;          ///< generators of all regions, lines counted twice
  std::size_t most_rays = 0;     ///< of one region
  std::size_t pairs = 0;         ///< of rays, tested for being neighbours when a plane cut
  std::size_t ray_bits = 0;      ///< of the largest entry of any ray
  std::size_t twist_bits = 0;    ///< of the largest entry of a leaf's twist
  std::size_t filter_hits = 0;   ///< twists that doubles judged
  std::size_t exact_checks = 0;  ///< of twists, those that doubles could not judge
  std::size_t proofs = 0;        ///< shapes of proofs by degree that were tried
  std::size_t examples = 0;      ///< grasps of the box decided one by one
  std::size_t parts = 0;         ///< pieces of the box that were tried

  /// Sums, and the larger of what is the largest.
  SearchWork& operator+=(const SearchWork& part);
};

/// The work, by name; the order is that of the members.
std::vector<std::pair<std::string, std::size_t>> counters(const SearchWork& work);

}  // namespace stickslip
