// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One call for a verdict by either engine, and the reference engine.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/core/sign.hpp"
#include "stickslip/engine/branch_and_bound.hpp"

namespace stickslip {

/// The work of the reference engine, by counters; reproducible.
struct StatesWork {
  std::size_t states = 0;          ///< distinct slip states of the grasp
  std::size_t states_refuted = 0;  ///< states refuted alone or in a group; all, if unstable
  std::size_t states_solved = 0;   ///< states that needed a system of their own
  std::size_t programs = 0;        ///< linear programs solved, for groups and for states
  std::size_t twists_carried = 0;  ///< programs spared, as the last twist refuted another group
  std::size_t double_pivots = 0;   ///< pivots of all programs, in double precision
  /// Exact pivots of all programs, where the proposed basis was not final.
  std::size_t exact_pivots = 0;
  std::size_t bases_confirmed = 0;  ///< programs whose double-precision basis was confirmed
  std::size_t largest_bits = 0;     ///< bits of the largest integer in exact elimination
};

/// The reference engine. It enumerates the slip states and solves their systems (Haas-Heger et
/// al., RSS 2018, Algorithm 2), with detachment decided exactly. It takes states in groups,
/// those with given signs of slip at some contacts. In the common system of a group the
/// friction of the other contacts is free in its cone. If this system has no solution, one
/// virtual twist refutes all states of the group. If it has one, the group is split, at worst
/// down to single states, whose systems are exact. Each enumerated state is refuted before a
/// grasp is called unstable.
///
/// Returns Stable with a witness, or Unstable with a refutation, never Undecided.
/// Deterministic. There are O(m^2) slip states, and O(m^3) programs in the worst case.
Verdict decide_by_states(const Problem& problem, StatesWork* work = nullptr);

/// The engines: kStates is the method of the paper and the reference. kAuto is kBranchAndBound,
/// which measures faster (bench/README.md).
enum class Engine { kAuto, kStates, kBranchAndBound };

/// The answer to a problem, and the work to find it.
struct Decision {
  Verdict verdict;                          ///< the verdict with its evidence
  std::variant<StatesWork, ConeWork> work;  ///< the work of the engine that ran

  /// Returns "states" or "branch-and-bound".
  const char* engine() const {
    return std::holds_alternative<StatesWork>(work) ? "states" : "branch-and-bound";
  }
};

/// Decides exactly whether an equilibrium exists (problem.hpp). `options` are those of branch
/// and bound. The verdict is Undecided only if they limit its nodes.
Decision decide(const Problem& problem, Engine engine = Engine::kAuto,
                const BranchAndBoundOptions& options = {});

/// \{ Returns the counters with their names, in a fixed order.
std::vector<std::pair<std::string, std::size_t>> counters(const StatesWork& work);
std::vector<std::pair<std::string, std::size_t>> counters(const ConeWork& work);
/// \}

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
