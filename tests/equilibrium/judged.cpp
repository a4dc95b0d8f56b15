// SPDX-License-Identifier: GPL-3.0-or-later
#include "judged.hpp"

#include <gtest/gtest.h>

namespace stickslip::test {

std::string judged_verdict(const LoadCase& load_case, RaysFrom rays_from) {
  const Problem problem(load_case.loaded, load_case.law);
  StatesWork work;
  const Verdict verdict = decide_by_states(problem, &work);
  EXPECT_LE(work.states_solved, work.states);
  EXPECT_GE(work.states_solved, 1u);
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    EXPECT_EQ(find_violation(problem, stable->witness), std::nullopt) << describe(load_case);
  } else if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
    EXPECT_EQ(check_refutation(problem, unstable->refutation, rays_from), std::nullopt)
        << describe(load_case) << to_text(unstable->refutation);
    EXPECT_EQ(work.states_solved, work.states);
  } else {
    ADD_FAILURE() << "undecided: " << describe(load_case);
  }
  return name_of(verdict);
}

std::string judged_verdicts(const LoadedGrasp& loaded) {
  const std::string unilateral = judged_verdict({loaded, NormalLaw::kUnilateral});
  const std::string bilateral = judged_verdict({loaded, NormalLaw::kBilateral});
  if (unilateral == bilateral) return unilateral;
  EXPECT_EQ(unilateral, "stable") << describe({loaded, NormalLaw::kUnilateral});
  return "unilateral " + unilateral + ", bilateral " + bilateral;
}

}  // namespace stickslip::test
