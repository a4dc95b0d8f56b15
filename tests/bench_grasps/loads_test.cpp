// SPDX-License-Identifier: GPL-3.0-or-later
// Instances have the verdicts they are constructed to have, by both engines.
#include "loads.hpp"

#include <gtest/gtest.h>

#include "hard.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/equilibrium/decide.hpp"

namespace stickslip::bench {
namespace {

std::string verdict_of(const Question& question, Engine engine) {
  return name_of(decide(Problem(question.loaded, question.law), engine).verdict);
}

bool is_stable(const Question& question) {
  return verdict_of(question, Engine::kCone) == "stable";
}

std::string text_of(const Instance& instance) {
  return instance.family + '\n' + write_grasp(instance.question.loaded);
}

TEST(PlantedLoad, IsStableUnderBothLaws) {
  for (const Layout layout : {Layout::kRound, Layout::kArc, Layout::kEdges, Layout::kGrid}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Grasp grasp = make_grasp(layout, 6, true, seed);
      for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
        const Question question = plain_question(grasp, planted_load(grasp, law, seed), law);
        EXPECT_EQ(verdict_of(question, Engine::kCone), "stable")
            << to_string(law) << write_grasp(question.loaded);
      }
    }
  }
}

TEST(StableInstances, AreStableByBothEngines) {
  for (const Instance& instance : stable_instances(5, 2 * kStableFamilies)) {
    EXPECT_EQ(instance.expected, Expected::kStable);
    EXPECT_EQ(verdict_of(instance.question, Engine::kCone), "stable") << text_of(instance);
    EXPECT_EQ(verdict_of(instance.question, Engine::kStates), "stable") << text_of(instance);
  }
}

TEST(UnstableInstances, AreUnstableByBothEngines) {
  for (const Instance& instance : unstable_instances(5, 2 * kUnstableFamilies, is_stable)) {
    EXPECT_EQ(instance.expected, Expected::kUnstable);
    EXPECT_EQ(verdict_of(instance.question, Engine::kCone), "unstable") << text_of(instance);
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

TEST(ThresholdLoad, IsTheLastThatIsHeld) {
  const Rational just_beyond = 1 + parse_rational("1e-12");
  const Rational just_below = 1 - parse_rational("1e-12");
  for (const Layout layout : {Layout::kJaws, Layout::kDisc}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Grasp grasp = make_grasp(layout, 4, true, seed);
      const Wrench threshold = threshold_load(layout, grasp);
      for (const Engine engine : {Engine::kStates, Engine::kCone}) {
        const auto verdict = [&](const Rational& factor) {
          return verdict_of(plain_question(grasp, factor * threshold), engine);
        };
        EXPECT_EQ(verdict(just_below), "stable") << name_of(layout) << seed;
        EXPECT_EQ(verdict(1), "stable") << name_of(layout) << seed;
        EXPECT_EQ(verdict(just_beyond), "unstable") << name_of(layout) << seed;
      }
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
