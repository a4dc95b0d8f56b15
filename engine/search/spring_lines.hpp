// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What springs do along the lines of a region: on both of its ways, so that a twist that
/// refutes the region must not see it. Such twists are a subspace, which doubles would miss. So
/// it is with rays at infinity whose springs alone act, and balance each other.
#pragma once

#include <vector>

#include "stickslip/engine/force_span.hpp"
#include "stickslip/engine/motion_region.hpp"

namespace stickslip::search_detail {

/// Of a region: for each line l the sum of k' N (N.l) over its springs, or each N where k' is
/// uncertain.
class SpringLines {
 public:
  SpringLines(const Law& law, const MotionRegion& region);

  /// Takes these generators as it takes lines; false if it has all of them.
  bool add(const std::vector<std::size_t>& generators);
  /// Whether springs do nothing there.
  bool empty() const { return across_.empty(); }
  /// Whether a generator is one of them.
  bool has(std::size_t generator) const { return !empty() && is_in_[generator] != 0; }
  /// One generator for each line, and all rays.
  const std::vector<std::size_t>& generators() const { return generators_; }
  /// A twist of the subspace near this one.
  Row twist_near(const Row& y) const;
  /// Takes from a wrench, in the law's units, what no such twist sees.
  void project(Reals& wrench) const;

 private:
  void note(std::size_t generator);
  void find_twists();

  const Law& law_;
  const MotionRegion& region_;
  bool has_springs_ = false;   ///< else all of this is empty
  std::vector<char> is_in_{};  ///< by generator
  std::vector<std::size_t> generators_;
  std::vector<RationalRow> seen_{};  ///< what springs do on them
  std::vector<RationalRow> basis_;   ///< of the twists, each 1 in a column of its own
  std::vector<std::size_t> columns_;
  std::vector<Reals> across_;  ///< what springs do, orthonormal, in the law's units
};

}  // namespace stickslip::search_detail
