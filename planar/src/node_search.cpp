// SPDX-License-Identifier: GPL-3.0-or-later
#include "node_search.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/motion/pull_rule.hpp"

namespace stickslip::planar_detail {

std::optional<NodeSearch::Step> NodeSearch::examine(
    const Region& region, std::size_t depth, bool exactly,
    const std::function<bool(const Relaxed&)>& ends) {
  ++work_.nodes;
  work_.depth = std::max(work_.depth, depth);
  if (region.is_void()) {
    ++work_.voids;
    return Step{TwistLeaf{Row(3)}, {}};
  }
  forces_.read(region);
  work_.visits += forces_.visits();
  for (const bool precisely : {false, true}) {
    const bool is_last = precisely || (exactly && forces_.all_are_single());
    const SearchResult found = search_.search(forces_, precisely, work_);
    if (found.separated) {
      if (auto leaf = search_.confirm(problem_, region, forces_, found.twist, work_,
                                      exactly && is_last)) {
        ++work_.leaves;
        return Step{std::move(*leaf), {}};
      }
    } else {
      const std::optional<ContactSplit> split = search_.widest_gap(forces_, found);
      if (ends({found, split.has_value(), precisely, is_last})) return std::nullopt;
      if (split) return split_at(region, *split);
    }
    if (is_last) break;
  }
  return std::nullopt;
}

NodeSearch::Step NodeSearch::split_at(const Region& region, const ContactSplit& split) {
  ++(std::holds_alternative<SlipSplit>(split) ? work_.slip_splits : work_.separation_splits);
  return split_region(problem_, region, split);
}

bool append_wall(const Problem& family, const DoubleModel& model, Region wall,
                 const PullRule* pull, std::size_t node_limit, Trees& trees, ConeWork& work) {
  NodeSearch search(family, model, pull, work);
  const std::size_t last = work.nodes + node_limit;
  const auto examine = [&](const Region& region,
                           std::size_t depth) -> std::optional<NodeSearch::Step> {
    if (work.nodes == last) return std::nullopt;
    return search.examine(region, depth, false, [](const auto&) { return false; });
  };
  return append_tree(std::move(wall), trees, examine);
}

}  // namespace stickslip::planar_detail
