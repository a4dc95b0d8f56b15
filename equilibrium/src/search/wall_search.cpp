// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_search.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/equilibrium/search/tree_walk.hpp"
#include "twist_search.hpp"

namespace stickslip::equilibrium_detail {

bool append_wall(const Problem& family, const DoubleModel& model, Region wall,
                 const Direction* direction, std::size_t node_limit, Refutation& trees,
                 ConeWork& work) {
  using Step = Branch<RefutationNode, Region>;
  RegionForces forces(family, model);
  TwistSearch search(model, direction);
  const std::size_t last = work.nodes + node_limit;
  const auto examine = [&](const Region& region, std::size_t depth) -> std::optional<Step> {
    if (work.nodes == last) return std::nullopt;
    ++work.nodes;
    work.depth = std::max(work.depth, depth);
    if (region.is_void()) {
      ++work.voids;
      return Step{VirtualWorkLeaf{}, {}};
    }
    forces.read(region);
    work.visits += forces.visits();
    for (const bool precisely : {false, true}) {
      const SearchResult found = search.search(forces, precisely, work);
      if (found.separated) {
        if (auto leaf = search.confirm(family, region, forces, found.twist, work, false)) {
          ++work.leaves;
          return Step{std::move(*leaf), {}};
        }
      } else if (const auto split = search.widest_gap(forces, found)) {
        ++(std::holds_alternative<SlipSplit>(*split) ? work.slip_splits
                                                     : work.separation_splits);
        return split_region(family, region, *split);
      }
    }
    return std::nullopt;
  };
  return append_tree(std::move(wall), trees, examine);
}

}  // namespace stickslip::equilibrium_detail
