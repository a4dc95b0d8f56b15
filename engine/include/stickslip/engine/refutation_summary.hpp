// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A summary of the tree that refutes all motions of one grasp in the plane.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "stickslip/core/integer_vector.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/engine/problem.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip {

/// A summary of a refutation, for people.
struct RefutationSummary {
  std::size_t nodes = 0;   ///< nodes of the tree, leaves included
  std::size_t leaves = 0;  ///< leaves whose regions are not void
  /// The conditions of the leaf that is shown, in words ("contact 3 slips +"), and its twist.
  std::vector<std::string> largest_leaf;
  std::map<ContactId, Sign> largest_leaf_slips;  ///< the contacts whose slip that leaf fixes
  std::set<ContactId> largest_leaf_open;         ///< the contacts that are open in it
  IntegerVector<3> largest_leaf_twist{};         ///< the virtual twist (x, y, r) of that leaf
};

/// Returns the counts and the leaf to show. Among the leaves with the fewest conditions it
/// takes the one that looks most like the failure when the object moves against the leaf's
/// twist: where the most contacts then slip or open as the leaf says. It takes the first of
/// equals, and without a problem all are equal. Takes O(nodes) times the number of conditions.
RefutationSummary summarize(const Trees& refutation, const Problem* problem = nullptr);

}  // namespace stickslip
