// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Why a search found no proof, and how to say so.
#pragma once

#include <cstddef>
#include <vector>

#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// The reason why a search for a tree ended.
enum class SearchEnd {
  kNone,       ///< it found one
  kNodes,      ///< the limit of nodes
  kPoints,     ///< a region has too many points (tree_walk.hpp)
  kDepth,      ///< a node lies deeper than the format allows
  kTwist,      ///< a virtual twist refutes a region in doubles, but not exactly, in any bits
  kPlane,      ///< no plane cuts a region whose forces balance in doubles
  kCandidate,  ///< a function of the caller did (TreeSearch::on_candidate, on_doubt)
  kUnbounded   ///< motions of a margin grow without end, or many are far
};

/// All that is known of a question that was not decided.
struct SearchReport {
  SearchEnd end = SearchEnd::kNone;  ///< why the last tree for all motions ended
  std::size_t node_limit = 0;        ///< the limit for one tree
  bool is_spent = false;             ///< the limit of all trees together was reached
  bool is_wide = false;              ///< the question is about many grasps
  bool is_far = false;               ///< only motions far beyond the load's size are left
  std::vector<Rational> near{};  ///< an equilibrium in doubles around which there is no proof
  bool is_free = false;          ///< a motion beside that equilibrium changes no force
};

/// Returns the answer of a search that reached this limit of nodes: one for one grasp in the
/// plane, or for all that a margin or a region needs.
Undecided limit_reached(std::size_t node_limit);

/// Returns the report in words. They name what was reached, and nothing that was not.
Undecided undecided_by(const SearchReport& report);

}  // namespace stickslip
