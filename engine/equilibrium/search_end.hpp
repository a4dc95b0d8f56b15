// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Why a search for a proof found none, and what to say of it.
#pragma once

#include <cstddef>
#include <vector>

#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// What ended a search for a tree.
enum class SearchEnd {
  kNone,   ///< it found one, or met a region with too many points (tree_walk.hpp)
  kNodes,  ///< the limit of nodes
  kDepth,  ///< a node lies deeper than the format allows
  kTwist,  ///< a virtual twist that refutes a region in doubles does not, exactly, in any bits
  kPlane,  ///< no plane cuts a region whose forces balance in doubles
  kCandidate,  ///< whoever takes candidates
  kUnbounded   ///< motions that grow without end, of a margin
};

/// What is known of a question that was not decided.
struct SearchReport {
  SearchEnd end = SearchEnd::kNone;  ///< of the last tree for all motions
  std::size_t node_limit = 0;        ///< of a tree
  bool is_spent = false;             ///< the limit of all trees together was reached
  bool is_wide = false;              ///< the question is about many grasps
  bool is_far = false;               ///< what is left are motions far beyond the load's size
  std::vector<Rational> near{};  ///< an equilibrium in doubles around which there is no proof
};

/// Of a search for one grasp in the plane, or for all that a margin or a region needs.
Undecided limit_reached(std::size_t node_limit);

/// In words that name what was reached, and nothing that was not.
Undecided undecided_by(const SearchReport& report);

}  // namespace stickslip
