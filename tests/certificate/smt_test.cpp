// SPDX-License-Identifier: GPL-3.0-or-later
// The SMT-LIB export, put to Z3 and to cvc5: sat iff the grasp is stable. One process of each
// answers all problems, with (reset) between them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "cases.hpp"
#include "stickslip/certificate/smtlib.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// Lines of standard output.
std::vector<std::string> run(const std::string& program, const std::string& options,
                             const std::string& text) {
  if (program.find("NOTFOUND") != std::string::npos) {
    throw std::runtime_error(
        "this test needs the programs z3 and cvc5. On Debian: apt-get "
        "install z3 cvc5; then run cmake again");
  }
  const std::string path =
      ::testing::TempDir() + "stickslip_export_" + std::to_string(getpid()) + ".smt2";
  {
    std::ofstream file(path);
    file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
  }
  const std::string command = "'" + program + "' " + options + " '" + path + "' 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string output;
  char buffer[4096];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe)) {
    output.append(buffer, count);
  }
  const int status = pclose(pipe);
  std::remove(path.c_str());
  EXPECT_EQ(status, 0) << command << "\n" << output;
  std::vector<std::string> lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

void expect_confirmed(const std::string& program, const std::string& options) {
  std::string text;
  std::vector<std::string> names;
  std::vector<std::string> expected;
  std::size_t stable = 0;
  for (const test::Case& one : test::all_cases()) {
    const Question question = one.question();
    text += "(reset)\n" + smtlib_text(question);
    const Verdict verdict = decide(Problem(question.loaded, question.law)).verdict;
    stable += std::holds_alternative<Stable>(verdict) ? 1 : 0;
    names.push_back(one.name);
    expected.emplace_back(std::holds_alternative<Stable>(verdict) ? "sat" : "unsat");
  }
  const std::vector<std::string> answers = run(program, options, text);
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
    EXPECT_EQ(run(program, options, text), std::vector<std::string>{"sat"}) << program;
  }
}

TEST(SmtLib, IrrationalPreloadIsRefused) {
  const LoadedGrasp loaded{Grasp({{{0, 0}, {1, 1}, 0, 1, 1}}), {}};
  EXPECT_THROW(smtlib_text({loaded, NormalLaw::kUnilateral, std::nullopt, {}}), InputError);
}

}  // namespace
}  // namespace stickslip
