// SPDX-License-Identifier: GPL-3.0-or-later
#include "find_flaw.hpp"

#include <utility>

#include "region.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// Pushes a node's children, the first one last; or returns what is wrong with the node.
struct NodeCheck {
  const Problem& problem;
  const Region& region;
  std::vector<Region>& pending;

  std::optional<std::string> operator()(const SlipSplit& node) const {
    if (node.contact.index() >= problem.size()) return "no such contact";
    if (region.label(node.contact)) return "a second slip split of one contact";
    for (const Sign slip : {Sign::kNegative, Sign::kZero, Sign::kPositive}) {
      pending.push_back(region.slip_child(problem, node.contact, slip));
    }
    return std::nullopt;
  }
  std::optional<std::string> operator()(const SeparationSplit& node) const {
    if (node.contact.index() >= problem.size()) return "no such contact";
    if (problem.law() == NormalLaw::kBilateral) return "a separation under the bilateral law";
    for (const Separation side : {Separation::kOpen, Separation::kClosed}) {
      pending.push_back(region.separation_child(problem, node.contact, side));
    }
    return std::nullopt;
  }
  std::optional<std::string> operator()(const PlaneCut& node) const {
    if (is_zero(node.plane)) return "a plane without a normal";
    const auto plane = vector_of<5>(node.plane);
    pending.push_back(region.plane_child(plane, Side::kNegative));
    pending.push_back(region.plane_child(plane, Side::kPositive));
    return std::nullopt;
  }
  std::optional<std::string> operator()(const PartSplit& /*node*/) const {
    return "a part of a box, in the tree of one grasp";
  }
  std::optional<std::string> operator()(const MovingLeaf& /*node*/) const {
    return "a leaf whose twist moves, in the tree of one grasp in the plane";
  }
  std::optional<std::string> operator()(const TwistLeaf& node) const {
    if (!refutes(problem, region, node)) return "the twist does not refute the region";
    return std::nullopt;
  }
};

}  // namespace

std::optional<std::string> find_flaw(const Problem& problem, const Trees& refutation) {
  std::vector<Region> pending{Region::root(problem)};
  for (std::size_t index = 0; index < refutation.size(); ++index) {
    const std::string place = "node " + std::to_string(index) + ": ";
    if (pending.empty()) return place + "the tree is complete before it";
    const Region region = std::move(pending.back());
    pending.pop_back();
    const auto flaw = std::visit(NodeCheck{problem, region, pending}, refutation[index]);
    if (flaw) return place + *flaw;
  }
  if (!pending.empty()) return "the tree ends before all children are there";
  return std::nullopt;
}

void validate(const Problem& problem, const Verdict& verdict) {
  std::optional<std::string> flaw;
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    flaw = find_violation(problem, stable->witness());
  } else if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
    flaw = find_flaw(problem, unstable->tree);
  }
  require(!flaw, flaw ? flaw->c_str() : "");
}

}  // namespace stickslip
