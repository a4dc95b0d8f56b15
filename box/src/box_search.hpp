// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Trees about a box, found by branch and bound as those of one grasp are
/// (equilibrium/search/branch_and_bound.hpp). What doubles propose is confirmed exactly.
#pragma once

#include <optional>

#include "box_region.hpp"

namespace stickslip::box_detail {

/// One search, or several that share a limit.
class BoxSearch {
 public:
  /// `direction` is that of list 2, or null. All must outlive this.
  BoxSearch(const BoxModel& model, const Direction* direction, std::size_t node_limit)
      : model_(model), direction_(direction), nodes_left_(node_limit) {}

  /// Appends a tree that refutes the region; false if none was found, and then `trees` has some
  /// nodes more.
  bool refute(const BoxRegion& region, BoxTrees& trees);

  std::size_t nodes() const { return nodes_; }

  /// Where the last search that failed gave up: friction slopes and normal forces by contact of
  /// a relaxed equilibrium, and its motion (d, h) in rounded numbers.
  struct Relaxed {
    std::array<double, 4> motion{};
    std::vector<double> normal;
    std::vector<double> tangential;
  };
  const Relaxed& relaxed() const { return relaxed_; }

 private:
  struct Split {
    BoxNode node;
    IntegerVector5 plane;
    bool three = false;  ///< slip: strict, on, strict; else kept, strict
  };
  class Wolfe;

  bool visit(const BoxRegion& region, BoxTrees& trees, std::size_t depth);
  std::optional<IntegerVector3> confirm(const BoxRegion& region, const Wolfe& found) const;
  std::optional<Split> split(const BoxRegion& region, const Wolfe& found) const;

  const BoxModel& model_;
  const Direction* direction_;
  std::size_t nodes_left_;
  std::size_t nodes_ = 0;
  Relaxed relaxed_;
};

}  // namespace stickslip::box_detail
