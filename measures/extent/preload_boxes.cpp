// SPDX-License-Identifier: GPL-3.0-or-later
#include "preload_boxes.hpp"

#include <algorithm>

#include "engine/box/effort.hpp"
#include "engine/box/short_numbers.hpp"
#include "engine/box/single_grasp.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

Rational sum_of(const RationalRow& preloads) {
  Rational sum = 0;
  for (const Rational& preload : preloads) sum += preload;
  return sum;
}

ContactGroups contacts_of_one_direction(const GraspBox& grasp) {
  if (grasp.mechanism) return {};
  const auto is_along = [](const RationalRow& n, const RationalRow& other) {
    const Rational along = dot(n, other);
    return along.sign() > 0 && along * along == dot(n, n) * dot(other, other);
  };
  ContactGroups groups;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& other) {
      return is_along(grasp.contacts[i].normal, grasp.contacts[other.front()].normal);
    });
    if (group == groups.end()) {
      groups.push_back({i});
    } else {
      group->push_back(i);
    }
  }
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                              [](const auto& group) { return group.size() == 1; }),
               groups.end());
  return groups;
}

}  // namespace stickslip

namespace stickslip::extent_detail {

using namespace box_detail;
namespace {

template <class Row>
GraspBox preloaded(GraspBox grasp, const Row& preloads) {
  require(preloads.size() == grasp.contacts.size(), "a preload for each contact");
  for (std::size_t i = 0; i < preloads.size(); ++i) {
    if constexpr (std::is_same_v<Row, PreloadBox>) {
      grasp.contacts[i].preload = preloads[i];
    } else {
      grasp.contacts[i].preload = point_interval(preloads[i]);
    }
  }
  return grasp;
}

template <class Function>
RationalRow corner(const PreloadBox& box, Function number) {
  RationalRow row;
  for (const Interval& side : box) row.push_back(number(side));
  return row;
}

}  // namespace

RationalRow preloads_of(const GraspBox& grasp) {
  RationalRow preloads;
  for (const UncertainContact& c : grasp.contacts) preloads.push_back(c.preload.low);
  return preloads;
}

GraspBox with_preloads(GraspBox grasp, const RationalRow& preloads) {
  return preloaded(std::move(grasp), preloads);
}

GraspBox with_preloads(GraspBox grasp, const PreloadBox& preloads) {
  return preloaded(std::move(grasp), preloads);
}

RationalRow low_corner(const PreloadBox& box) {
  return corner(box, [](const Interval& side) { return side.low; });
}

RationalRow high_corner(const PreloadBox& box) {
  return corner(box, [](const Interval& side) { return side.high; });
}

PreloadBox below_sum(PreloadBox box, const Rational& most) {
  const Rational left = most - sum_of(low_corner(box));
  require(left.sign() >= 0, "preloads of that sum");
  for (Interval& side : box) side.high = std::min<Rational>(side.high, side.low + left);
  return box;
}

std::pair<PreloadBox, PreloadBox> halves(const PreloadBox& box) {
  const auto widest = std::max_element(
      box.begin(), box.end(),
      [](const Interval& a, const Interval& b) { return a.high - a.low < b.high - b.low; });
  const auto side = static_cast<std::size_t>(widest - box.begin());
  std::pair<PreloadBox, PreloadBox> parts{box, box};
  parts.first[side].high = parts.second[side].low = widest->middle();
  return parts;
}

Rational size_of(const WrenchBox& wrench) {
  Rational most = 0;
  for (const Interval& component : wrench) most = std::max<Rational>(most, abs(component.low));
  return power_of_two_above(most);
}

bool seems_held(const GraspBox& point, NormalLaw law, const SearchOptions& options) {
  if (effort_for(point).decides_singles) return is_stable(point, law, options) == true;
  const GraspLaw middle = GraspLaw(point, law).middle();
  const auto found = equilibria_in_doubles(middle, needs_enclosure(point));
  return std::any_of(found.begin(), found.end(),
                     [&](const NearEquilibrium& near) { return may_be_within(middle, near); });
}

SearchOptions of_many(SearchOptions options, const GraspBox& grasp) {
  if (options.node_limit == 0) options.node_limit = effort_for(grasp).nodes_of_many;
  return options;
}

bool may_refuse(const GraspBox& load, const PreloadBox& box, NormalLaw law,
                const SearchOptions& options) {
  for (const RationalRow& preloads : {middle_of(box), high_corner(box), low_corner(box)}) {
    if (seems_held(with_preloads(load, preloads), law, options)) return false;
  }
  return true;
}

std::optional<ProvedPreloads> refuse(const GraspBox& load, const PreloadBox& box, NormalLaw law,
                                     const SearchOptions& options) {
  ProvedPreloads refused{with_preloads(load, box)};
  BoxDecision decision = prove_box(refused.box, law, options, 0);
  if (!std::holds_alternative<Unstable>(decision.verdict)) return std::nullopt;
  refused.proof = std::move(decision);
  return refused;
}

}  // namespace stickslip::extent_detail
