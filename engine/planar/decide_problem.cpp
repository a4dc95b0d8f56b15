// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/decide_problem.hpp"

#include <utility>

namespace stickslip {

Decision decide(const Problem& problem, const SearchOptions& options) {
  if (options.engine == Engine::kStates) {
    StatesWork work;
    Verdict verdict = decide_by_states(problem, &work);
    return {std::move(verdict), work};
  }
  BranchWork work;
  Verdict verdict = branch_and_bound(problem, options, &work);
  return {std::move(verdict), work};
}

}  // namespace stickslip
