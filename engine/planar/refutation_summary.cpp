// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/refutation_summary.hpp"

#include <utility>

namespace stickslip {
namespace {

/// Returns the conditions that lead to the children of a node, in order; none for a leaf.
std::vector<std::string> child_conditions(const TreeNode& node) {
  if (const auto* slip = std::get_if<SlipSplit>(&node)) {
    const std::string contact = "contact " + std::to_string(slip->contact.index());
    return {contact + " slips +", contact + " sticks", contact + " slips -"};
  }
  if (const auto* separation = std::get_if<SeparationSplit>(&node)) {
    const std::string contact = "contact " + std::to_string(separation->contact.index());
    return {contact + " is closed", contact + " is open"};
  }
  if (const auto* plane = std::get_if<PlaneCut>(&node)) {
    const Row& p = plane->plane;
    const std::string value =
        "(" + p[0].str() + ", " + p[1].str() + ", " + p[2].str() + ").d + " + p[3].str();
    return {value + " >= 0", value + " <= 0"};
  }
  return {};
}

/// Returns how many contacts slip or open as the leaf says when the object moves against its
/// twist.
std::size_t count_alike(const RefutationSummary& found, const Problem& problem) {
  const Twist drift = twist_of(negated(found.largest_leaf_twist));
  std::size_t count = 0;
  for (const auto& [contact, slip] : found.largest_leaf_slips) {
    if (sign_of(power(problem.row(contact).tangent, drift)) == slip) ++count;
  }
  for (const ContactId contact : found.largest_leaf_open) {
    if (power(problem.row(contact).normal, drift).sign() > 0) ++count;
  }
  return count;
}

}  // namespace

RefutationSummary summarize(const Trees& refutation, const Problem* problem) {
  RefutationSummary summary;
  summary.nodes = refutation.size();
  // The path to the current node: the conditions of the children still to come, last first.
  struct Level {
    const TreeNode* node;
    std::vector<std::string> conditions;
    std::size_t current = 0;
  };
  std::vector<Level> path;
  std::size_t most_alike = 0;
  for (const TreeNode& node : refutation) {
    const auto* leaf = std::get_if<TwistLeaf>(&node);
    if (leaf != nullptr && !is_zero(leaf->twist)) {
      ++summary.leaves;
      if (summary.leaves == 1 || path.size() <= summary.largest_leaf.size()) {
        RefutationSummary found = summary;
        found.largest_leaf.clear();
        found.largest_leaf_slips.clear();
        found.largest_leaf_open.clear();
        found.largest_leaf_twist = vector_of<3>(leaf->twist);
        for (const Level& level : path) {
          found.largest_leaf.push_back(level.conditions[level.current]);
          if (const auto* slip = std::get_if<SlipSplit>(level.node)) {
            constexpr Sign kSlips[] = {Sign::kPositive, Sign::kZero, Sign::kNegative};
            found.largest_leaf_slips[slip->contact] = kSlips[level.current];
          } else if (const auto* separation = std::get_if<SeparationSplit>(level.node)) {
            if (level.current == 1) found.largest_leaf_open.insert(separation->contact);
          }
        }
        const std::size_t alike = problem == nullptr ? 0 : count_alike(found, *problem);
        if (summary.leaves == 1 || path.size() < summary.largest_leaf.size() ||
            alike > most_alike) {
          summary = std::move(found);
          most_alike = alike;
        }
      }
    }
    std::vector<std::string> conditions = child_conditions(node);
    if (!conditions.empty()) {
      path.push_back({&node, std::move(conditions), 0});
      continue;
    }
    while (!path.empty() && ++path.back().current == path.back().conditions.size()) {
      path.pop_back();
    }
  }
  return summary;
}

}  // namespace stickslip
