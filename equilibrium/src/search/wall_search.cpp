// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_search.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/equilibrium/search/tree_walk.hpp"
#include "twist_search.hpp"

namespace stickslip::equilibrium_detail {

bool append_wall(const Problem& family, const DoubleModel& model, Region wall,
                 const Direction<3>* direction, std::size_t node_limit, Refutation& trees,
                 ConeWork& work) {
  using Step = Branch<RefutationNode, Node>;
  RayTable table;
  TwistSearch search(model, direction);
  const std::size_t last = work.nodes + node_limit;
  const auto examine = [&](Node node, std::size_t depth) -> std::optional<Step> {
    if (work.nodes == last) return std::nullopt;
    ++work.nodes;
    work.depth = std::max(work.depth, depth);
    if (node.region.is_void()) {
      ++work.voids;
      return Step{VirtualWorkLeaf{}, {}};
    }
    table.read(family, model, node);
    const SearchResult found = search.search(node, table, work);
    if (found.separated) {
      auto leaf = search.confirm(family, node, table, found.twist, work, false);
      if (!leaf) return std::nullopt;
      ++work.leaves;
      return Step{std::move(*leaf), {}};
    }
    const std::optional<ContactSplit> split = search.widest_gap(node, found);
    if (!split) return std::nullopt;
    ++(std::holds_alternative<SlipSplit>(*split) ? work.slip_splits : work.separation_splits);
    return node.split(family, *split);
  };
  return append_tree(Node(family, std::move(wall)), trees, examine);
}

}  // namespace stickslip::equilibrium_detail
