// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of mutated certificates: both checkers say the same of each, to the rule, node and
// path; what changes the meaning is rejected by the rule that names it; what does not is
// accepted; a third opinion settles what could be either.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>

#include "judge.hpp"
#include "margin_truth.hpp"
#include "mutations.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::CheckerAnswer;
using test::Expectation;
using test::Mutant;
using test::Mutants;

constexpr std::size_t kLongest = 120;  ///< nodes; larger trees are accepted_test's

Mutants all_mutants(std::size_t& certificates) {
  test::RandomSource random(5);
  std::vector<test::Certified> originals;
  for (test::Certified& one : test::all_certificates()) {
    if (one.size() > kLongest) continue;
    // The engines often find the same evidence.
    if (!originals.empty() && originals.back().text == one.text) continue;
    originals.push_back(std::move(one));
  }
  certificates = originals.size();
  Mutants mutants;
  for (std::size_t i = 0; i < originals.size(); ++i) {
    const test::Certified& one = originals[i];
    if (one.verdict == "stable") {
      mutate_witness(random, one, mutants);
    } else {
      mutate_tree(random, one, mutants);
    }
    mutate_question(random, one, mutants);
    mutate_grasp(random, one, mutants);
    mutate_bytes(random, one, mutants);
    // A few are enough for what depends little on the certificate.
    if (i % 8 < 2) mutate_syntax(random, one, mutants);
    test::swap_grasps(one, originals[(i + 1) % originals.size()], mutants);
    test::swap_grasps(one, random.pick(originals), mutants);
  }
  test::mutate_margins(random, mutants);
  return mutants;
}

std::string show(const Mutant& mutant) {
  return mutant.kind + " of " + mutant.of + "\n" + describe(mutant.input);
}

void expect_as_made(const Mutant& mutant, const CheckerAnswer& answer) {
  const std::string seen = describe(answer) + "\n" + show(mutant);
  switch (mutant.expected.sort) {
    case Expectation::Sort::kAccepted:
      EXPECT_EQ(answer.result, "accepted") << seen;
      break;
    case Expectation::Sort::kRule:
      EXPECT_EQ(answer.rule, mutant.expected.rule) << seen;
      if (mutant.expected.node) {
        EXPECT_EQ(answer.node, mutant.expected.node) << seen;
      }
      break;
    case Expectation::Sort::kRejected:
      EXPECT_EQ(answer.result, "rejected") << seen;
      break;
    case Expectation::Sort::kMalformed:
      EXPECT_EQ(answer.result, "malformed") << seen;
      break;
    case Expectation::Sort::kNothing:
      break;
  }
}

/// The grasp file and question of an accepted certificate have that verdict.
void expect_true(const Mutant& mutant) {
  try {
    const QuestionOptions& options = mutant.input.options;
    if (options.direction || options.preload_direction) {
      EXPECT_EQ(test::lie_of(mutant.input), "") << show(mutant);
      return;
    }
    const Question question =
        ask(parse_grasp(mutant.input.grasp, "grasp"), mutant.input.options);
    const std::string verdict = question.box() != nullptr
                                    ? name_of(decide_box(*question.box(), question.law).verdict)
                                    : name_of(decide(problem_of(question)).verdict);
    const bool claims_stable = mutant.input.certificate.find("\"twist\"") != std::string::npos;
    EXPECT_EQ(verdict, claims_stable ? "stable" : "unstable") << show(mutant);
  } catch (const InputError& error) {
    ADD_FAILURE() << "accepted, but " << error.what() << "\n" << show(mutant);
  }
}

/// Whether core reads the grasp file as the checkers do.
void expect_grasp_read_alike(const Mutant& mutant, const CheckerAnswer& answer) {
  bool legible = true;
  std::string reason;
  try {
    const Question question = ask(parse_grasp(mutant.input.grasp, "grasp", Intervals::kAllowed),
                                  mutant.input.options);
    if (question.box() == nullptr) problem_of(question);
  } catch (const InputError& error) {
    legible = false;
    reason = error.what();
  }
  EXPECT_EQ(answer.result != "malformed", legible) << describe(answer) << "\n"
                                                   << reason << "\n"
                                                   << show(mutant);
}

TEST(Mutations, EachIsAnsweredAlikeAndRightly) {
  std::size_t certificates = 0;
  const Mutants mutants = all_mutants(certificates);
  EXPECT_GE(certificates, 40u);
  EXPECT_GE(mutants.size(), 2000u);
  std::vector<test::CheckerInput> inputs;
  for (const Mutant& mutant : mutants) inputs.push_back(mutant.input);
  const std::vector<CheckerAnswer> python = test::ask_python_checker(inputs);

  std::vector<CheckerAnswer> answers;
  std::map<std::string, std::map<std::string, std::size_t>> tally;
  std::size_t opinions = 0;
  for (std::size_t i = 0; i < mutants.size() && !HasFatalFailure(); ++i) {
    const Mutant& mutant = mutants[i];
    const CheckerAnswer cpp = answers.emplace_back(ask_cpp_checker(mutant.input));
    EXPECT_TRUE(cpp.agrees_with(python[i]))
        << "C++: " << describe(cpp) << "\nPython: " << describe(python[i]) << "\n"
        << show(mutant);
    expect_as_made(mutant, cpp);
    if (cpp.result == "accepted") expect_true(mutant);
    if (mutant.kind == "bytes of the grasp file") expect_grasp_read_alike(mutant, cpp);
    if (cpp.result != "malformed") {
      if (const auto third = test::third_opinion(mutant.input)) {
        ++opinions;
        EXPECT_EQ(third->rule, cpp.rule) << describe(cpp) << "\n" << show(mutant);
        EXPECT_EQ(third->node, cpp.node) << describe(cpp) << "\n" << show(mutant);
      }
    }
    ++tally[mutant.kind][cpp.result];
  }

  test::expect_js_checker_agrees(inputs, answers);
  test::expect_proved_checker_agrees(inputs, answers);
  std::cout << certificates << " certificates, " << mutants.size() << " mutants of "
            << tally.size() << " kinds, " << opinions << " third opinions\n";
  for (const auto& [kind, results] : tally) {
    std::cout << "  " << kind << ":";
    for (const auto& [result, count] : results) std::cout << " " << count << " " << result;
    std::cout << "\n";
  }
}

}  // namespace
}  // namespace stickslip
