// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The wrenches of springs along the lines of a region. A line goes both ways, so a twist that
/// refutes the region must not see these. Such twists are a subspace, which doubles would miss.
/// The same is true of rays at infinity on which springs alone act, and balance each other.
#pragma once

#include <vector>

#include "stickslip/engine/force_span.hpp"
#include "stickslip/engine/motion_region.hpp"

namespace stickslip::search_detail {

/// The wrenches of springs along a region's lines: for each line l the sum of k' N (N.l) over
/// its springs. A spring whose k' is uncertain counts by itself, with N.
class SpringLines {
 public:
  SpringLines(const Law& law, const MotionRegion& region);

  /// Takes these generators as it takes lines. Returns false if it has all of them, or if there
  /// are no springs.
  bool add(const std::vector<std::size_t>& generators);
  /// Returns whether springs do nothing along them.
  bool empty() const { return across_.empty(); }
  /// Returns whether a generator is one of them.
  bool has(std::size_t generator) const { return !empty() && is_in_[generator] != 0; }
  /// Returns one generator for each line, and all rays that were taken.
  const std::vector<std::size_t>& generators() const { return generators_; }
  /// Returns a twist of the subspace near this one.
  Row twist_near(const Row& y) const;
  /// Takes from a wrench, in the law's units, the part that no such twist sees.
  void project(Reals& wrench) const;

 private:
  void note(std::size_t generator);
  void find_twists();

  const Law& law_;
  const MotionRegion& region_;
  bool has_springs_ = false;   ///< there are springs; else all of this is empty
  std::vector<char> is_in_{};  ///< whether a generator is in, by its index
  std::vector<std::size_t> generators_;
  std::vector<RationalRow> seen_{};  ///< the springs' wrenches on these generators
  std::vector<RationalRow> basis_;   ///< a basis of the twists, each 1 in a column of its own
  std::vector<std::size_t> columns_;
  std::vector<Reals> across_;  ///< the springs' wrenches, orthonormal, in the law's units
};

}  // namespace stickslip::search_detail
