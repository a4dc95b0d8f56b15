// SPDX-License-Identifier: GPL-3.0-or-later
#include "judged.hpp"

#include <gtest/gtest.h>

#include "both_checkers.hpp"
#include "engine/planar/find_flaw.hpp"
#include "shares.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip::test {

namespace {

void judge(const LoadCase& load_case, const Problem& problem, const Verdict& verdict,
           RaysFrom rays_from) {
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    EXPECT_EQ(find_violation(problem, stable->witness()), std::nullopt) << describe(load_case);
    EXPECT_LE(shares_of(problem, stable->witness()).fractional, 3u) << describe(load_case);
  } else if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
    EXPECT_EQ(check_refutation(problem, unstable->tree, rays_from), std::nullopt)
        << describe(load_case) << to_text(unstable->tree);
    EXPECT_EQ(find_flaw(problem, unstable->tree), std::nullopt) << describe(load_case);
  } else {
    ADD_FAILURE() << "undecided: " << describe(load_case);
    return;
  }
  expect_accepted_by_both(load_case.loaded, load_case.law, verdict);
}

}  // namespace

std::string judged_verdict(const LoadCase& load_case, RaysFrom rays_from) {
  const Problem problem(load_case.loaded, load_case.law);
  StatesWork work;
  const Verdict by_states = decide_by_states(problem, &work);
  judge(load_case, problem, by_states, rays_from);
  EXPECT_LE(work.states_solved, work.states);
  if (std::holds_alternative<Unstable>(by_states)) {
    EXPECT_EQ(work.states_refuted, work.states);
  } else {
    EXPECT_LT(work.states_refuted, work.states);
  }
  const Verdict by_cones = branch_and_bound(problem);
  judge(load_case, problem, by_cones, rays_from);
  EXPECT_STREQ(name_of(by_states), name_of(by_cones)) << describe(load_case);
  return name_of(by_states);
}

std::string judged_verdicts(const LoadedGrasp& loaded) {
  const std::string unilateral = judged_verdict({loaded, NormalLaw::kUnilateral});
  const std::string bilateral = judged_verdict({loaded, NormalLaw::kBilateral});
  if (unilateral == bilateral) return unilateral;
  EXPECT_EQ(unilateral, "stable") << describe({loaded, NormalLaw::kUnilateral});
  return "unilateral " + unilateral + ", bilateral " + bilateral;
}

}  // namespace stickslip::test
