// SPDX-License-Identifier: GPL-3.0-or-later
#include "crowd_forces.hpp"

#include <algorithm>
#include <utility>

namespace stickslip::planar_detail {

bool CrowdForces::enter(const Region& region, std::size_t depth) {
  region_ = &region;
  ++work_.nodes;
  work_.depth = std::max(work_.depth, depth);
  if (region.is_barred()) {
    ++work_.voids;
    return false;
  }
  forces_.read(region);
  work_.visits += forces_.visits();
  return true;
}

/// Searches for a twist; `again` takes contacts one by one where those of a group differ.
SearchResult CrowdForces::nearest(bool again) {
  is_last_ = again || (exactly_ && forces_.all_are_single());
  return search_.search(forces_, again, work_);
}

std::optional<Row> CrowdForces::confirm(const Double3& twist) {
  auto y = search_.confirm(problem_, *region_, forces_, twist, work_, exactly_ && is_last_);
  if (y) ++work_.leaves;
  return y;
}

CrowdRelaxation CrowdForces::relaxed(const SearchResult& found) const {
  const WidestGap widest = search_.widest_gap(forces_, found);
  return {found, widest.at, widest.at || is_last_ ? widest.size : 1};
}

std::optional<CrowdForces::Branch> CrowdForces::split(const CrowdRelaxation& relaxed) {
  if (!relaxed.broken) return std::nullopt;
  return branch(std::visit([](const auto& at) { return TreeNode(at); }, *relaxed.broken));
}

CrowdForces::Branch CrowdForces::branch(const TreeNode& node) {
  if (const auto* slip = std::get_if<SlipSplit>(&node)) {
    ++work_.slip_splits;
    return {node, region_->children(problem_, *slip)};
  }
  if (const auto* separation = std::get_if<SeparationSplit>(&node)) {
    ++work_.separation_splits;
    return {node, region_->children(problem_, *separation)};
  }
  ++work_.leaves;
  ++work_.filter_misses;
  return {node, {}};
}

std::optional<SearchResult> CrowdForces::relaxation(const Region& region) {
  forces_.read(region);
  SearchResult found = search_.search(forces_, true, work_);
  if (found.separated) return std::nullopt;
  return found;
}

}  // namespace stickslip::planar_detail
