// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The reference engine: enumerate the slip states and solve the system of each (Haas-Heger et
/// al., RSS 2018, Algorithm 2), with detachment decided exactly inside each state.
#pragma once

#include <cstddef>

#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip {

/// What the engine did; reproducible.
struct StatesWork {
  std::size_t states = 0;         ///< distinct slip states of the grasp
  std::size_t states_solved = 0;  ///< those whose system was solved: all, if unstable
  std::size_t patterns = 0;  ///< separation patterns refuted, each by a verified virtual twist
  std::size_t programs = 0;  ///< linear programs solved
  std::size_t double_pivots = 0;    ///< of all programs, in double precision
  std::size_t exact_pivots = 0;     ///< of all programs, where the proposed basis was not final
  std::size_t bases_confirmed = 0;  ///< programs whose double-precision basis was confirmed
  std::size_t largest_bits = 0;     ///< of an integer in exact elimination
};

/// Stable with a witness, or Unstable with a refutation; never Undecided. Deterministic.
/// O(m^2) slip states, for each a linear program of at most 4 + 2m rows, and O(m^3) programs
/// in all when every contact can both open and close.
Verdict decide_by_states(const Problem& problem, StatesWork* work = nullptr);

}  // namespace stickslip
