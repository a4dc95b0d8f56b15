// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The verdict about one grasp in the plane whose numbers are certain, by either engine.
#pragma once

#include <variant>

#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/engine/states_engine.hpp"

namespace stickslip {

/// The answer to a problem, and the work to find it.
struct Decision {
  Verdict verdict;                            ///< the verdict with its evidence
  std::variant<StatesWork, BranchWork> work;  ///< the work of the engine that ran

  /// Returns "states" or "branch-and-bound".
  const char* engine() const {
    return std::holds_alternative<StatesWork>(work) ? "states" : "branch-and-bound";
  }
};

/// Decides exactly whether an equilibrium exists (problem.hpp). The verdict is Undecided only
/// if the options limit the nodes of a branch and bound.
Decision decide(const Problem& problem, const SearchOptions& options = {});

}  // namespace stickslip
