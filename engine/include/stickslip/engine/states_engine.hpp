// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The reference engine: the method of the paper, with exact linear programs.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/engine/problem.hpp"
#include "stickslip/engine/verdict.hpp"

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

/// Returns the counters with their names, in the order of the members.
std::vector<std::pair<std::string, std::size_t>> counters(const StatesWork& work);

}  // namespace stickslip
