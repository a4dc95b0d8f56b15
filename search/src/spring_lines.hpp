// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What springs do along the lines of a region: on both of its ways, so that a twist that
/// refutes the region must not see it. Such twists are a subspace, which doubles would miss.
#pragma once

#include <vector>

#include "stickslip/search/force_span.hpp"
#include "stickslip/search/motion_region.hpp"

namespace stickslip::search_detail {

/// Of a region: for each line l the sum of k' N (N.l) over its springs, or each N where k' is
/// uncertain.
class SpringLines {
 public:
  SpringLines(const Law& law, const MotionRegion& region);

  /// Whether springs do nothing there.
  bool empty() const { return across_.empty(); }
  /// Whether a generator is one of the lines.
  bool has_line(std::size_t generator) const { return !empty() && generator < lines_; }
  /// A twist of the subspace near this one.
  Row twist_near(const Row& y) const;
  /// Takes from a wrench, in the law's units, what no such twist sees.
  void project(Reals& wrench) const;

 private:
  std::size_t lines_ = 0;           ///< how many generators are lines
  std::vector<RationalRow> basis_;  ///< of the twists, each 1 in a column of its own
  std::vector<std::size_t> columns_;
  std::vector<Reals> across_;  ///< what springs do, orthonormal, in the law's units
};

}  // namespace stickslip::search_detail
