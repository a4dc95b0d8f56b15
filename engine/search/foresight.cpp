// SPDX-License-Identifier: GPL-3.0-or-later
#include "foresight.hpp"

#include <algorithm>

namespace stickslip::search_detail {

Foresight::Foresight(std::size_t contacts) : records_(2 * contacts) {}

std::optional<LawForces::Found> Foresight::enter(std::size_t depth) {
  if (depth == 0) children_.clear();  // another tree begins
  depth_ = depth;
  std::optional<LawForces::Found> found;
  if (!children_.empty() && children_.back().depth == depth) {
    found = std::move(children_.back().found);
    children_.pop_back();
  }
  return found;
}

void Foresight::expect(Children children) {
  for (auto child = children.rbegin(); child != children.rend(); ++child) {
    children_.push_back({depth_ + 1, std::move(*child)});
  }
}

void Foresight::sort(std::vector<SplitChoice>& splits) const {
  const auto chance = [&](const SplitChoice& split) {
    const Record& record = records_[index_of(split)];
    return record.served / record.tried;
  };
  std::stable_sort(
      splits.begin(), splits.end(),
      [&](const SplitChoice& a, const SplitChoice& b) { return chance(a) > chance(b); });
}

void Foresight::learn(const SplitChoice& split, bool has_served) {
  Record& record = records_[index_of(split)];
  ++record.tried;
  if (has_served) ++record.served;
}

}  // namespace stickslip::search_detail
