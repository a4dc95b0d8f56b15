// SPDX-License-Identifier: GPL-3.0-or-later
// The SMT-LIB export, put to Z3 and to cvc5: sat iff the grasp is stable. One process of each
// answers all problems, with (reset) between them.
#include <gtest/gtest.h>

#include <iostream>

#include "cases.hpp"
#include "smt_solver.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

void expect_confirmed(const std::string& program, const std::string& options) {
  std::string text;
  std::vector<std::string> names;
  std::vector<std::string> expected;
  std::size_t stable = 0;
  for (const test::Case& one : test::all_cases()) {
    const Question question = one.question();
    text += "(reset)\n" + smtlib_text(question);
    const Verdict verdict = decide(Problem(question.loaded(), question.law)).verdict;
    stable += std::holds_alternative<Stable>(verdict) ? 1 : 0;
    names.push_back(one.name);
    expected.emplace_back(std::holds_alternative<Stable>(verdict) ? "sat" : "unsat");
  }
  const std::vector<std::string> answers = test::ask_solver(program, options, text);
  ASSERT_EQ(answers.size(), names.size()) << (answers.empty() ? "" : answers.back());
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(answers[i], expected[i]) << names[i];
  EXPECT_GE(names.size(), 60u);
  EXPECT_GE(stable, 20u);
  EXPECT_GE(names.size() - stable, 20u);
  std::cout << names.size() << " exports, " << stable << " stable\n";
}

TEST(SmtLib, ConfirmedByZ3) {
  expect_confirmed(STICKSLIP_Z3, "-smt2");
}

TEST(SmtLib, ConfirmedByCvc5) {
  expect_confirmed(STICKSLIP_CVC5, "--lang=smt2 --incremental");
}

TEST(SmtLib, NameCannotLeaveItsComment) {
  const LoadedGrasp loaded{Grasp({}, "a\n(assert false)\r(assert false)"), {}};
  const std::string text = smtlib_text({loaded, NormalLaw::kUnilateral, std::nullopt, {}});
  for (const auto& [program, options] :
       {std::pair{STICKSLIP_Z3, "-smt2"}, std::pair{STICKSLIP_CVC5, "--lang=smt2"}}) {
    EXPECT_EQ(test::ask_solver(program, options, text), std::vector<std::string>{"sat"})
        << program;
  }
}

TEST(SmtLib, IrrationalPreloadIsRefused) {
  const LoadedGrasp loaded{Grasp({{{0, 0}, {1, 1}, 0, 1, 1}}), {}};
  EXPECT_THROW(smtlib_text({loaded, NormalLaw::kUnilateral, std::nullopt, {}}), InputError);
}

}  // namespace
}  // namespace stickslip
