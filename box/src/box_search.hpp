// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Trees about a box, found by branch and bound as those of one grasp are
/// (equilibrium/search/branch_and_bound.hpp). What doubles propose is confirmed exactly.
#pragma once

#include <optional>

#include "box_region.hpp"
#include "stickslip/equilibrium/search/search_end.hpp"
#include "stickslip/equilibrium/search/tree_walk.hpp"

namespace stickslip::box_detail {

/// One search, or several that share a limit.
class BoxSearch {
 public:
  /// `direction` is that of list 2, or null. All must outlive this.
  BoxSearch(const BoxModel& model, const Direction<3>* direction, std::size_t node_limit)
      : model_(model), direction_(direction), nodes_left_(node_limit) {}

  /// Appends a tree that refutes the region; false if none was found, and then `trees` has some
  /// nodes more.
  bool refute(const BoxRegion& region, BoxTrees& trees);

  /// Of the last search.
  SearchEnd end() const { return end_; }
  std::size_t nodes() const { return nodes_; }
  /// Rules of leaves that doubles did not decide.
  std::size_t exact_leaves() const { return exact_leaves_; }

 private:
  using BoxBranch = equilibrium_detail::Branch<BoxNode, BoxRegion>;
  class Wrenches;

  std::optional<BoxBranch> examine(const BoxRegion& region, std::size_t depth);
  std::optional<IntegerVector3> confirm(const BoxRegion& region, const Wrenches& wrenches,
                                        const std::array<double, 3>& twist);

  const BoxModel& model_;
  const Direction<3>* direction_;
  std::size_t nodes_left_;
  SearchEnd end_ = SearchEnd::kNone;
  std::size_t nodes_ = 0;
  std::size_t exact_leaves_ = 0;
};

}  // namespace stickslip::box_detail
