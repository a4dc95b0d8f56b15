// SPDX-License-Identifier: GPL-3.0-or-later
// The states engine against Z3 on small grasps of all families, half of them and more
// degenerate.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "family.hpp"
#include "judged.hpp"
#include "paper_grasps.hpp"
#include "smt_oracle.hpp"

namespace stickslip {
namespace {

using test::LoadCase;
using test::RandomSource;

void expect_agreement(const char* family, const std::vector<LoadCase>& load_cases) {
  const std::vector<std::string> expected = test::ask_z3(load_cases);
  std::size_t stable = 0;
  for (std::size_t i = 0; i < load_cases.size(); ++i) {
    const std::string verdict = test::judged_verdict(load_cases[i]);
    EXPECT_EQ(verdict, expected[i]) << describe(load_cases[i]);
    stable += verdict == "stable" ? 1 : 0;
  }
  const std::size_t unstable = load_cases.size() - stable;
  std::cout << family << ": " << load_cases.size() << " grasps, " << stable << " stable, "
            << unstable << " unstable\n";
  // Each verdict must have its share, or the family tests little.
  EXPECT_GE(5 * stable, load_cases.size());
  EXPECT_GE(5 * unstable, load_cases.size());
}

NormalLaw random_law(RandomSource& random) {
  return random.one_in(2) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
}

std::size_t few_contacts(RandomSource& random) {
  return static_cast<std::size_t>(random.pick<int>({0, 1, 2, 2, 3, 3, 3, 4, 4, 4}));
}

Rational tie(RandomSource& random) {
  const char* size = random.pick<const char*>({"0", "1e-9", "1e-12", "1e-18"});
  return random.one_in(2) ? parse_rational(size) : Rational(-parse_rational(size));
}

Wrench any_wrench(RandomSource& random, const Grasp& grasp, NormalLaw law) {
  switch (random.between(0, 3)) {
    case 0:
      return test::planted_wrench(random, grasp, law);
    case 1:
      return test::threshold_wrench(random, grasp, tie(random));
    case 2:
      return test::planted_wrench(random, grasp, law) +
             tie(random) * test::small_wrench(random);
    default:
      return test::small_wrench(random);
  }
}

LoadCase degenerate(RandomSource& random, int round) {
  const Grasp grasp = test::degenerate_grasp(random, few_contacts(random));
  const NormalLaw law = random_law(random);
  return {{grasp, round % 4 == 0 ? test::planted_wrench(random, grasp, law)
                                 : test::small_wrench(random)},
          law};
}

LoadCase at_threshold(RandomSource& random, int) {
  const Grasp grasp = test::degenerate_grasp(random, few_contacts(random));
  const NormalLaw law = random_law(random);
  return {{grasp, random.one_in(2) ? test::threshold_wrench(random, grasp, tie(random))
                                   : test::planted_wrench(random, grasp, law) +
                                         tie(random) * test::small_wrench(random)},
          law};
}

LoadCase nearly_degenerate(RandomSource& random, int) {
  const Rational epsilon = parse_rational(random.pick<const char*>({"1e-9", "1e-12", "1e-18"}));
  const Grasp grasp = test::near_degenerate_grasp(random, few_contacts(random), epsilon);
  const NormalLaw law = random_law(random);
  return {{grasp, any_wrench(random, grasp, law)}, law};
}

LoadCase generic(RandomSource& random, int) {
  const Grasp grasp = test::generic_grasp(random, few_contacts(random));
  const NormalLaw law = random_law(random);
  return {{grasp, any_wrench(random, grasp, law)}, law};
}

TEST(AgainstZ3, RandomGrasps) {
  const struct {
    const char* name;
    std::uint64_t seed;
    int count;
    LoadCase (*make)(RandomSource&, int round);
  } families[] = {{"degenerate", 2018, 160, degenerate},
                  {"degenerate, loads at and near thresholds", 2019, 120, at_threshold},
                  {"nearly degenerate", 2020, 100, nearly_degenerate},
                  {"generic", 2021, 120, generic}};
  for (const auto& [name, seed, count, make] : families) {
    RandomSource random(seed);
    std::vector<LoadCase> load_cases;
    for (int round = 0; round < count; ++round) load_cases.push_back(make(random, round));
    expect_agreement(name, load_cases);
  }
}

TEST(AgainstZ3, GraspsOfThePaper) {
  std::vector<LoadCase> load_cases;
  for (const char* tie : {"-1e-12", "0", "1e-12"}) {
    for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
      for (const int preload : {0, 1}) {
        for (const Wrench& w :
             {Wrench{0, 1, 0}, Wrench{0, -1, 0}, Wrench{1, Rational(1, 2), 0}}) {
          load_cases.push_back(
              {{test::fig1_grasp(preload), w + Wrench{0, parse_rational(tie), 0}}, law});
        }
        for (const Wrench& w : {Wrench{0, 2, 0}, Wrench{0, -2, 0}, Wrench{0, 0, 3}}) {
          load_cases.push_back(
              {{test::fig4_grasp(preload), w + Wrench{0, parse_rational(tie), 0}}, law});
        }
      }
    }
  }
  expect_agreement("Figs. 1 and 4", load_cases);
}

// Z3 finds no multiple in the gaps of a margin, and one among all if anything is resisted.
TEST(AgainstZ3, MarginsAlongLoadsAndPreloads) {
  RandomSource random(45);
  std::vector<test::FamilyCase> families;
  std::vector<std::string> expected;
  for (int round = 0; round < 250; ++round) {
    const NormalLaw law = random_law(random);
    const auto contacts = static_cast<std::size_t>(random.between(1, 4));
    const Grasp grasp = test::degenerate_grasp(random, contacts);
    std::optional<Wrench> direction;
    if (random.one_in(2)) direction = test::small_wrench(random);
    std::optional<PreloadDirection> growth;
    if (!direction || random.one_in(2)) {
      growth.emplace();
      for (std::size_t i = 0; i < contacts; ++i)
        growth->preloads.emplace_back(random.between(0, 2));
      growth->preloads.front() += 1;
    } else if (*direction == Wrench{}) {
      direction->y = 1;
    }
    const Question question =
        test::margin_question({grasp, any_wrench(random, grasp, law)}, law, direction, growth);
    const auto margin = std::get<Margin>(find_margin(problem_of(question)));
    families.push_back({question, {}});
    expected.emplace_back(margin.resisted.empty() ? "unstable" : "stable");
    for (const MultipleRange& gap : test::gaps_of(margin)) {
      families.push_back({question, gap});
      expected.emplace_back("unstable");
    }
  }
  EXPECT_EQ(test::ask_z3(families), expected);
  const auto gaps = std::count(expected.begin(), expected.end(), "unstable");
  std::cout << "margins: " << gaps << " ranges refuted\n";
  EXPECT_GT(gaps, 150);
  EXPECT_GT(static_cast<std::ptrdiff_t>(expected.size()) - gaps, 100);
}

}  // namespace
}  // namespace stickslip
