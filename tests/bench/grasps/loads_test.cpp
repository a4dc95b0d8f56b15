// SPDX-License-Identifier: GPL-3.0-or-later
// Instances have the verdicts they are constructed to have, by both engines.
#include "loads.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "check.hpp"
#include "hard.hpp"
#include "shares.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/decide_problem.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip::bench {
namespace {

std::string verdict_of(const Question& question, Engine engine) {
  return name_of(decide(Problem(question.loaded(), question.law), by(engine)).verdict);
}

bool is_stable(const Question& question) {
  return verdict_of(question, Engine::kBranchAndBound) == "stable";
}

std::string text_of(const Instance& instance) {
  return instance.family + '\n' + write_grasp(instance.question.loaded());
}

TEST(StableInstances, AreStableByBothEngines) {
  for (const Instance& instance : stable_instances(5, 2 * kStableFamilies)) {
    EXPECT_EQ(instance.expected, Expected::kStable);
    EXPECT_EQ(verdict_of(instance.question, Engine::kBranchAndBound), "stable")
        << text_of(instance);
    EXPECT_EQ(verdict_of(instance.question, Engine::kStates), "stable") << text_of(instance);
  }
}

// On a threshold every contact has to give all its friction; else one to three shares do,
// however many contacts stick (a third of those along straight edges).
TEST(StableInstances, AreStatedInFewWords) {
  for (std::size_t family = 0; family < kStableFamilies; ++family) {
    for (const std::size_t contacts : {30, 300}) {
      const Instance instance = make_stable(family, contacts, 1);
      SCOPED_TRACE(instance.family + ' ' + std::to_string(contacts));
      const Problem problem(instance.question.loaded(), instance.question.law);
      const Verdict verdict = branch_and_bound(problem);
      const Witness& witness = std::get<Stable>(verdict).witness();
      const test::ShareCount shares = test::shares_of(problem, witness);
      const bool on_threshold = family == 8 || family == 9;
      const bool varied = family >= 10;
      EXPECT_LE(shares.fractional, on_threshold ? 0u : 3u);
      if (on_threshold) {
        EXPECT_EQ(shares.nonzero, contacts);
      } else {
        EXPECT_LE(shares.nonzero, 3u);
      }
      const std::size_t bytes = certificate_text(instance.question, verdict, "test").size();
      // Each number of a varied motion has a few dozen digits a contact.
      EXPECT_LE(bytes, 500 + (on_threshold ? 10 * contacts : varied ? 200 * contacts : 0));
    }
  }
}

TEST(UnstableInstances, AreUnstableByBothEngines) {
  for (const Instance& instance : unstable_instances(5, 2 * kUnstableFamilies, is_stable)) {
    EXPECT_EQ(instance.expected, Expected::kUnstable);
    EXPECT_EQ(verdict_of(instance.question, Engine::kBranchAndBound), "unstable")
        << text_of(instance);
    EXPECT_EQ(verdict_of(instance.question, Engine::kStates), "unstable") << text_of(instance);
  }
}

TEST(Instances, AreDeterministic) {
  for (std::size_t family = 0; family < kUnstableFamilies; ++family) {
    EXPECT_EQ(text_of(make_unstable(family, 8, 3, is_stable)),
              text_of(make_unstable(family, 8, 3, is_stable)));
  }
  for (std::size_t family = 0; family < kStableFamilies; ++family) {
    EXPECT_EQ(text_of(make_stable(family, 8, 3)), text_of(make_stable(family, 8, 3)));
  }
}

// The closed forms of loads.hpp against the margin.
TEST(ThresholdLoad, IsTheEndOfTheMargin) {
  for (const Layout layout : {Layout::kJaws, Layout::kDisc}) {
    for (const std::size_t contacts : {2, 6, 20, 100}) {
      const Grasp grasp = make_grasp(layout, contacts, true, contacts);
      Question question = plain_question(grasp, {});
      question.direction = row_of(threshold_load(layout, grasp));
      const auto result = find_margin(problem_of(question));
      const auto& margin = std::get<Margin>(result);
      ASSERT_EQ(margin.resisted.size(), 1U) << name_of(layout) << ' ' << contacts;
      EXPECT_EQ(margin.resisted[0].low, 0);
      EXPECT_EQ(margin.resisted[0].high, Rational(1));
      std::istringstream file(write_grasp(question.loaded()));
      std::istringstream proof(margin_certificate_text(question, margin, "test"));
      stickslip_check::Options options;
      const RationalRow& u = *question.direction;
      options.direction.emplace();
      for (const Rational& entry : u) options.direction->emplace_back(to_string(entry));
      EXPECT_TRUE(std::holds_alternative<stickslip_check::Accepted>(
          stickslip_check::check(file, proof, options)))
          << name_of(layout) << ' ' << contacts;
    }
  }
}

TEST(FindThreshold, EndsWithTwoSidesThatEnginesAgreeOn) {
  int found = 0;
  for (std::size_t f = 0; f < kHardFamilies; ++f) {
    const HardGrasp hard = hard_grasp(static_cast<HardFamily>(f), 4, 1);
    const auto threshold = find_threshold(hard, NormalLaw::kUnilateral, is_stable);
    if (!threshold) continue;
    ++found;
    EXPECT_EQ(verdict_of(threshold->held, Engine::kStates), "stable") << f;
    EXPECT_EQ(verdict_of(threshold->too_much, Engine::kStates), "unstable") << f;
  }
  EXPECT_GE(found, 8);
}

}  // namespace
}  // namespace stickslip::bench
