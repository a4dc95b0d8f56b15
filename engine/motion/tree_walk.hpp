// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The walk of branch and bound, whatever the nodes are.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "stickslip/core/cancellation.hpp"

namespace stickslip {

/// A node of a tree with its children.
template <class Node, class Region>
struct BranchOf {
  Node node;                     ///< a split or a leaf
  std::vector<Region> children;  ///< the children's regions, in order; a leaf has none
};

/// Whether regions of this type know when they have more points than a tree may hold.
template <class Region, class = void>
constexpr bool kIsLimited = false;
template <class Region>
constexpr bool
    kIsLimited<Region, std::void_t<decltype(std::declval<Region>().has_too_many_points())>> =
        true;

/// Appends a tree in preorder, depth first. `examine(region, depth)` returns an optional
/// BranchOf, or nothing to end the walk; a region of too many points ends it, too. Returns
/// false if the walk was ended: then the tree is not whole.
template <class Region, class Node, class Examine>
bool append_tree(Region root, std::vector<Node>& tree, Examine examine) {
  std::vector<std::pair<Region, std::size_t>> pending;
  pending.emplace_back(std::move(root), 0);
  while (!pending.empty()) {
    throw_if_cancelled();
    auto [region, depth] = std::move(pending.back());
    pending.pop_back();
    if constexpr (kIsLimited<Region>) {
      if (region.has_too_many_points()) return false;
    }
    auto branch = examine(std::move(region), depth);
    if (!branch) return false;
    tree.push_back(std::move(branch->node));
    for (auto child = branch->children.rbegin(); child != branch->children.rend(); ++child) {
      pending.emplace_back(std::move(*child), depth + 1);
    }
  }
  return true;
}

}  // namespace stickslip
