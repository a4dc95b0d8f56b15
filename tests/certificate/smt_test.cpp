// SPDX-License-Identifier: GPL-3.0-or-later
// The SMT-LIB export, put to Z3 and to cvc5: sat iff the grasp is stable. One process of each
// answers all problems, with (reset) between them.
#include <gtest/gtest.h>

#include <iostream>

#include "cases.hpp"
#include "smt_solver.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/box_verdict.hpp"

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

/// One grasp from a file, which may be in space.
Question asked(const std::string& members, const QuestionOptions& options = {}) {
  return ask(parse_any_grasp(R"({"format": "stickslip-grasp/2", )" + members + "}", "test"),
             options);
}

// Coulomb's cone in Z3: a contact at (1, 2, 3) that presses with 10 holds 5 across, in whatever
// direction, and no more; two that are preloaded by 4 hold the weight 4 mu + 4 mu.
TEST(SmtLib, SpaceAndIrrationalLengths) {
  struct Export {
    std::string members;
    bool stable;
  };
  const std::string single = R"("contacts": [{"position": [1, 2, 3], "normal": [0, 0, 2],
                                              "friction": "1/2", "stiffness": 3}],)";
  const auto pinch = [](const std::string& weight) {
    return R"("defaults": {"friction": "1/2", "preload": 4}, "contacts": [
        {"position": [-2, 0, 0], "normal": [1, 0, 0]},
        {"position": [2, 0, 0], "normal": [-1, 0, 0]}],
        "wrench": [0, 0, )" +
           weight + ", 0, 0, 0]";
  };
  const std::string across = R"("defaults": {"friction": 1, "preload": 2}, "contacts": [
      {"position": [-1, -1], "normal": [1, 1]}, {"position": [1, 1], "normal": [-1, -1]}],
      "wrench": )";
  // Together they hold 2 mu P = 4 along (1, -1).
  const std::vector<Export> exports = {
      {single + R"("wrench": [3, 4, -10, "-32", "19", "-2"])", true},
      {single + R"("wrench": ["3.001", 4, -10, "-32", "19.003", "-2.002"])", false},
      {single + R"("wrench": [3, 4, 10, "8", "-1", "-2"])", false},
      {pinch("-4"), true},
      {pinch("\"-4.001\""), false},
      {across + R"(["2.828", "-2.828", 0])", true},
      {across + R"(["2.829", "-2.829", 0])", false},
  };
  std::string text;
  for (const Export& one : exports) {
    const Question question = asked(one.members);
    EXPECT_STREQ(name_of(decide_box(*question.box(), question.law).verdict),
                 one.stable ? "stable" : "unstable")
        << one.members;
    text += "(reset)\n" + smtlib_text(question);
  }
  const std::vector<std::string> answers = test::ask_solver(STICKSLIP_Z3, "-smt2", text);
  ASSERT_EQ(answers.size(), exports.size());
  for (std::size_t i = 0; i < exports.size(); ++i) {
    EXPECT_EQ(answers[i], exports[i].stable ? "sat" : "unsat") << exports[i].members;
  }
}

TEST(SmtLib, BoxesAreRefused) {
  QuestionOptions options;
  options.uncertain = parse_tolerances("friction=10%");
  const Question question =
      asked(R"("contacts": [{"position": [0, 0], "normal": [0, 1], "friction": 1}],
               "wrench": [0, -1, 0])",
            options);
  EXPECT_THROW(smtlib_text(question), InputError);
}

}  // namespace
}  // namespace stickslip
