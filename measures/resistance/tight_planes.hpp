// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The planes that rays are on, which tell the rays that are neighbours.
#pragma once

#include <cstdint>
#include <vector>

#include "motion_ray.hpp"

namespace stickslip::resistance_detail {

/// A set of planes of a list: those that something is on.
class TightPlanes {
 public:
  explicit TightPlanes(std::size_t size) : words_((size + 63) / 64) {}
  void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  bool contains(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1) != 0; }
  bool is_in(const TightPlanes& other) const {
    for (std::size_t w = 0; w < words_.size(); ++w) {
      if ((words_[w] & ~other.words_[w]) != 0) return false;
    }
    return true;
  }
  TightPlanes& operator|=(const TightPlanes& other) {
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] |= other.words_[w];
    return *this;
  }
  friend TightPlanes operator&(TightPlanes a, const TightPlanes& b) {
    for (std::size_t w = 0; w < a.words_.size(); ++w) a.words_[w] &= b.words_[w];
    return a;
  }

 private:
  std::vector<std::uint64_t> words_;
};

/// Returns the planes of the list that the ray is on, with room for `more` planes at the end.
inline TightPlanes tight_at(const MotionRays& rays, RayIndex ray,
                            const std::vector<PlaneIndex>& planes, std::size_t more = 0) {
  TightPlanes result(planes.size() + more);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (rays[ray].values[planes[k]] == 0) result.insert(k);
  }
  return result;
}

/// Returns true if no third ray is on all planes that both are on: the combinatorial test of
/// cone.cpp.
inline bool are_neighbours(const std::vector<TightPlanes>& tight, std::size_t a,
                           std::size_t b) {
  const TightPlanes shared = tight[a] & tight[b];
  for (std::size_t c = 0; c < tight.size(); ++c) {
    if (c != a && c != b && shared.is_in(tight[c])) return false;
  }
  return true;
}

}  // namespace stickslip::resistance_detail
