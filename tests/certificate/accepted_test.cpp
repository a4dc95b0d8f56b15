// SPDX-License-Identifier: GPL-3.0-or-later
// What both engines certify, both checkers accept; so do they the committed certificates.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "both_checkers.hpp"
#include "cases.hpp"

namespace stickslip {
namespace {

using test::CheckerAnswer;
using test::CheckerInput;

void expect_accepted(const std::vector<CheckerInput>& inputs,
                     const std::vector<std::string>& names) {
  const std::vector<CheckerAnswer> python = test::ask_python_checker(inputs);
  std::vector<CheckerAnswer> answers;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const CheckerAnswer cpp = answers.emplace_back(ask_cpp_checker(inputs[i]));
    EXPECT_EQ(cpp.result, "accepted") << names[i] << ": " << describe(cpp);
    EXPECT_EQ(python[i].result, "accepted") << names[i] << ": " << describe(python[i]);
  }
  test::expect_js_checker_agrees(inputs, answers);
  test::expect_proved_checker_agrees(inputs, answers);
}

TEST(Accepted, CertificatesOfBothEngines) {
  const std::vector<test::Certified> all = test::all_certificates();
  std::map<std::string, std::size_t> tally;
  std::vector<CheckerInput> inputs;
  std::vector<std::string> names;
  std::size_t largest = 0;
  for (const test::Certified& one : all) {
    inputs.push_back(one.input());
    names.push_back(one.name());
    const std::string engine =
        one.engine == Engine::kBranchAndBound ? "branch-and-bound, " : "states, ";
    ++tally[engine + to_string(one.about.options.law) + ", " + one.verdict];
    largest = std::max(largest, one.size());
  }
  expect_accepted(inputs, names);
  std::cout << all.size() << " certificates, the largest of " << largest << " lines\n";
  EXPECT_GE(all.size(), 40u);
  EXPECT_EQ(tally.size(), 8u);  // engines, laws, verdicts
  for (const auto& [sort, count] : tally) {
    std::cout << "  " << sort << ": " << count << "\n";
    EXPECT_GE(count, 10u) << sort;
  }
}

TEST(Accepted, CommittedCertificates) {
  std::vector<CheckerInput> inputs;
  std::vector<std::string> names;
  for (const test::CommittedCertificate& one : test::committed_certificates()) {
    inputs.push_back(one.input);
    names.push_back(one.name);
  }
  EXPECT_GE(inputs.size(), 40u);
  expect_accepted(inputs, names);
}

// certificate_text: integers from 2^53 on are strings, so JSON readers that take doubles for
// numbers lose nothing, and the format's limit on JSON integers is far.
TEST(Accepted, LargeNumbersAreStrings) {
  const Integer limit = Integer(1) << 53;
  for (const Integer& load : {Integer(limit - 1), limit, Integer(limit * limit)}) {
    const LoadedGrasp loaded{Grasp({{{0, 0}, {0, 1}, 0, 1, 0}}), {0, -Rational(load), 0}};
    const Question question{loaded, NormalLaw::kUnilateral, std::nullopt};
    const CheckerInput input =
        test::input_of(question, decide(Problem(loaded, question.law)).verdict);
    const std::string digits = load.str();
    const std::string expected =
        "\"twist\": [0," + (load < limit ? "-" + digits : "\"-" + digits + "\"") + ",0]";
    EXPECT_NE(input.certificate.find(expected), std::string::npos) << input.certificate;
    expect_accepted({input}, {digits});
  }
}

}  // namespace
}  // namespace stickslip
