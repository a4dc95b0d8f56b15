// SPDX-License-Identifier: GPL-3.0-or-later
// Margins along loads and preloads: the paper's thresholds, and every end against verdicts at
// it and beside it.
#include "stickslip/margin/margin.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "both_checkers.hpp"
#include "family.hpp"
#include "judged.hpp"
#include "paper_grasps.hpp"
#include "rounds.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::LoadCase;
using test::RandomSource;
using test::rounds;

std::string describe(const std::vector<MarginInterval>& resisted) {
  std::string text;
  for (const MarginInterval& interval : resisted) {
    text += "[" + to_string(interval.low) + ", " +
            (interval.high ? to_string(*interval.high) : "oo") + "] ";
  }
  return text;
}

Margin margin_of(const Question& question) {
  return std::get<Margin>(find_margin(problem_of(question)));
}

Margin margin_of(const LoadCase& load_case, const Wrench& direction) {
  return margin_of(test::margin_question(load_case.loaded, load_case.law, direction));
}

std::string resisted(const Grasp& grasp, const Wrench& direction, const Wrench& base = {},
                     NormalLaw law = NormalLaw::kUnilateral) {
  return describe(margin_of({{grasp, base}, law}, direction).resisted);
}

TEST(Margin, PapersThresholds) {
  EXPECT_EQ(resisted(test::fig1_grasp(1), {0, 1, 0}), "[0, 1] ");
  EXPECT_EQ(resisted(test::fig1_grasp(1), {0, -1, 0}), "[0, oo] ");
  EXPECT_EQ(resisted(test::fig1_grasp(0), {0, -1, 0}), "[0, oo] ");
  EXPECT_EQ(resisted(test::fig1_grasp(0), {0, 1, 0}), "[0, 0] ");
  EXPECT_EQ(resisted(test::fig4_grasp(1), {0, 1, 0}), "[0, 2] ");
  EXPECT_EQ(resisted(test::fig4_grasp(1), {0, -1, 0}), "[0, 2] ");
}

TEST(Margin, WithoutContactsOnlyTheZeroLoadIsResisted) {
  EXPECT_EQ(resisted(Grasp(), {1, 0, 0}), "[0, 0] ");
  EXPECT_EQ(resisted(Grasp(), {1, 0, 0}, {-1, 0, 0}), "[1, 1] ");
  EXPECT_EQ(resisted(Grasp(), {1, 0, 0}, {1, 0, 0}), "");
  EXPECT_EQ(resisted(Grasp(), {1, 0, 0}, {0, 1, 0}), "");
}

TEST(Margin, NeedsADirection) {
  const Problem problem(LoadedGrasp{test::fig1_grasp(1), {}}, NormalLaw::kUnilateral);
  EXPECT_THROW(find_margin(problem), ContractError);
  EXPECT_THROW(problem.along({}), ContractError);
  EXPECT_THROW(problem.along({{}, {0, 0, 0}}), ContractError);
  EXPECT_THROW(problem.along({{}, {0, 0, -1}}), ContractError);
  EXPECT_THROW(problem.along({{}, {1}}), ContractError);
  const Problem family = problem.along({{1, 0, 0}});
  EXPECT_THROW(family.along({{1, 0, 0}}), ContractError);
  EXPECT_THROW(decide_by_cones(family), ContractError);
  EXPECT_THROW(find_violation(family, {}), ContractError);
}

TEST(Margin, StopsAtTheNodeLimit) {
  const Problem problem(LoadedGrasp{test::fig1_grasp(1), {}}, NormalLaw::kUnilateral);
  ConeOptions options;
  options.node_limit = 3;
  MarginWork work;
  EXPECT_TRUE(std::holds_alternative<Undecided>(
      find_margin(problem.along({{0, 1, 0}}), options, &work)));
  EXPECT_LE(work.cone.nodes, 3U);
}

bool contains(const std::vector<MarginInterval>& resisted, const Rational& multiple) {
  for (const MarginInterval& interval : resisted) {
    if (multiple >= interval.low && (!interval.high || multiple <= *interval.high)) return true;
  }
  return false;
}

/// Ends, points just beside them, middles, and round numbers.
std::set<Rational> interesting_multiples(const std::vector<MarginInterval>& resisted) {
  const Rational tiny = parse_rational("1e-15");
  std::set<Rational> multiples{0, tiny, Rational(1, 3), 1, 2, 5, 1000000};
  Rational before = 0;
  const auto add_end = [&](const Rational& end) {
    multiples.insert({end, end + tiny, (before + end) / 2});
    if (end > tiny) multiples.insert(end - tiny);
    before = end;
  };
  for (const MarginInterval& interval : resisted) {
    add_end(interval.low);
    if (interval.high) add_end(*interval.high);
  }
  multiples.insert(before + 1);
  return multiples;
}

struct Tally {
  std::size_t intervals[4] = {};  ///< margins with 0, 1, 2, more intervals
  std::size_t unbounded = 0;
  std::size_t points = 0;  ///< intervals of one point, other than [0, 0]
  std::size_t verdicts = 0;
};

void expect_exact(const Question& question, Tally& tally) {
  const Margin margin = margin_of(question);
  std::string words;
  const test::CheckerInput input = test::input_of(question, margin);
  for (const std::string& word : test::command_line(input.options)) words += word + " ";
  SCOPED_TRACE(input.grasp + words + ": " + describe(margin.resisted));
  test::expect_accepted_by_both(question, margin);
  for (const Rational& multiple : interesting_multiples(margin.resisted)) {
    EXPECT_EQ(test::judged_verdict({test::member(question, multiple), question.law}),
              contains(margin.resisted, multiple) ? "stable" : "unstable")
        << "at " << to_string(multiple);
    ++tally.verdicts;
  }
  ++tally.intervals[std::min<std::size_t>(margin.resisted.size(), 3)];
  for (const MarginInterval& interval : margin.resisted) {
    tally.unbounded += interval.high ? 0 : 1;
    tally.points += interval.high == interval.low && !interval.low.is_zero() ? 1 : 0;
  }
}

void print(const char* family, const Tally& tally) {
  std::cout << family << ": margins with 0, 1, 2, more intervals: " << tally.intervals[0] << ' '
            << tally.intervals[1] << ' ' << tally.intervals[2] << ' ' << tally.intervals[3]
            << "; unbounded " << tally.unbounded << ", lone points " << tally.points << "; "
            << tally.verdicts << " verdicts\n";
}

TEST(Margin, EveryEndAgainstVerdictsOnDegenerateGrasps) {
  RandomSource random(611);
  Tally tally;
  for (int round = 0; round < rounds(120); ++round) {
    const auto contacts = static_cast<std::size_t>(random.between(0, 4));
    LoadCase load_case;
    load_case.law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    load_case.loaded.grasp = test::degenerate_grasp(random, contacts);
    if (!random.one_in(3)) load_case.loaded.wrench = test::small_wrench(random);
    Wrench direction = test::small_wrench(random);
    if (direction == Wrench{}) direction.x = 1;
    expect_exact(test::margin_question(load_case.loaded, load_case.law, direction), tally);
  }
  print("degenerate", tally);
  EXPECT_GE(tally.intervals[0], rounds(11U));
  EXPECT_GE(tally.intervals[1], rounds(11U));
  EXPECT_GE(tally.unbounded, rounds(11U));
}

TEST(Margin, EveryEndAgainstVerdictsOnGenericGrasps) {
  if (test::kSanitized) GTEST_SKIP() << "the degenerate ones run the same lines";
  RandomSource random(612);
  Tally tally;
  for (int round = 0; round < rounds(80); ++round) {
    const auto contacts = static_cast<std::size_t>(random.between(2, 6));
    LoadCase load_case;
    load_case.law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    load_case.loaded.grasp = test::generic_grasp(random, contacts);
    load_case.loaded.wrench =
        test::planted_wrench(random, load_case.loaded.grasp, load_case.law);
    // Half of the directions pass through a second stable load.
    Wrench direction = test::small_wrench(random);
    if (random.one_in(2)) {
      direction = test::planted_wrench(random, load_case.loaded.grasp, load_case.law) +
                  Rational(-1) * load_case.loaded.wrench;
    }
    if (direction == Wrench{}) direction.torque = 1;
    expect_exact(test::margin_question(load_case.loaded, load_case.law, direction), tally);
  }
  print("generic", tally);
  EXPECT_GE(tally.intervals[1], rounds(21U));
}

TEST(Margin, ScalesWithTheDirectionAndShiftsWithTheBase) {
  RandomSource random(613);
  for (int round = 0; round < rounds(40); ++round) {
    const Grasp grasp = test::generic_grasp(random, 4);
    const Wrench base = test::planted_wrench(random, grasp, NormalLaw::kUnilateral);
    Wrench direction = test::small_wrench(random);
    if (direction == Wrench{}) direction.y = -1;
    const Margin margin = margin_of({{grasp, base}, NormalLaw::kUnilateral}, direction);
    const Rational scale(3, 7);
    const Margin scaled = margin_of({{grasp, base}, NormalLaw::kUnilateral}, scale * direction);
    const Rational shift(1, 5);
    const Margin shifted = margin_of(
        {{grasp, base + Rational(-1) * shift * direction}, NormalLaw::kUnilateral}, direction);
    ASSERT_EQ(scaled.resisted.size(), margin.resisted.size());
    for (std::size_t k = 0; k < margin.resisted.size(); ++k) {
      const MarginInterval& interval = margin.resisted[k];
      EXPECT_EQ(scaled.resisted[k].low * scale, interval.low);
      ASSERT_EQ(scaled.resisted[k].high.has_value(), interval.high.has_value());
      if (interval.high) {
        EXPECT_EQ(*scaled.resisted[k].high * scale, *interval.high);
      }
    }
    // From further back the same ends are met, apart from those below 0 before.
    ASSERT_FALSE(shifted.resisted.empty());
    EXPECT_EQ(shifted.resisted.back().high.has_value(),
              margin.resisted.back().high.has_value());
    if (margin.resisted.back().high) {
      EXPECT_EQ(*shifted.resisted.back().high, *margin.resisted.back().high + shift);
    }
  }
}

const PreloadDirection kScale{true, {}};

std::string resisted_along(const Grasp& grasp, const Wrench& load,
                           const PreloadDirection& growth) {
  const LoadedGrasp loaded{grasp, load};
  return describe(
      margin_of(test::margin_question(loaded, NormalLaw::kUnilateral, std::nullopt, growth))
          .resisted);
}

// What friction holds of Figs. 1 and 4 is in proportion to the preload of the sides.
TEST(Margin, PreloadsThatHoldThePapersLoads) {
  EXPECT_EQ(resisted_along(test::fig1_grasp(1), {0, 1, 0}, kScale), "[1, oo] ");
  EXPECT_EQ(resisted_along(test::fig1_grasp(2), {0, 1, 0}, kScale), "[1/2, oo] ");
  EXPECT_EQ(resisted_along(test::fig1_grasp(1), {0, 0, 0}, kScale), "[0, oo] ");
  EXPECT_EQ(resisted_along(test::fig4_grasp(1), {0, 2, 0}, kScale), "[1, oo] ");
  EXPECT_EQ(resisted_along(test::fig1_grasp(0), {0, 1, 0}, {false, {1, 0, 1}}), "[1, oo] ");
  EXPECT_EQ(resisted_along(test::fig1_grasp(Rational(1, 2)), {0, 1, 0}, {false, {1, 0, 1}}),
            "[1/2, oo] ");
}

// What holds at 13/5 times the preloads slips at 2.8 times, and holds again at 3 times.
TEST(Margin, MorePreloadMayBreakAGrasp) {
  std::vector<Contact> contacts{{{0, -2}, {1, 0}}, {{2, -2}, {0, 1}}, {{2, -2}, {-1, 0}}};
  for (Contact& c : contacts) {
    c.friction = Rational(3, 2);
    c.preload = 1;
  }
  EXPECT_EQ(resisted_along(Grasp(contacts), {-2, -2, 1}, kScale), "[13/5, 8/3] [3, oo] ");
  Tally tally;
  expect_exact(test::margin_question({Grasp(contacts), {-2, -2, 1}}, NormalLaw::kUnilateral,
                                     std::nullopt, kScale),
               tally);
}

/// All in proportion, or one number for each contact that may have a preload, not all 0.
PreloadDirection random_growth(RandomSource& random, const Grasp& grasp) {
  if (random.one_in(2)) return kScale;
  PreloadDirection growth;
  Rational sum = 0;
  for (const Contact& c : grasp.contacts()) {
    const bool may = exact_sqrt(c.normal.x * c.normal.x + c.normal.y * c.normal.y).has_value();
    growth.rates.emplace_back(may ? random.between(sum.is_zero() ? 1 : 0, 2) : 0);
    sum += growth.rates.back();
  }
  return sum.is_zero() ? kScale : growth;
}

std::optional<Question> random_preload_margin(RandomSource& random, const LoadedGrasp& loaded,
                                              NormalLaw law) {
  std::optional<Wrench> direction;
  if (random.one_in(3)) direction = test::small_wrench(random);
  try {
    return test::margin_question(loaded, law, direction, random_growth(random, loaded.grasp));
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "there is no preload to scale");
    return std::nullopt;
  }
}

TEST(Margin, EveryEndAgainstVerdictsAlongPreloadsOfDegenerateGrasps) {
  RandomSource random(614);
  Tally tally;
  for (int round = 0; round < rounds(160); ++round) {
    const auto contacts = static_cast<std::size_t>(random.between(1, 4));
    const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const LoadedGrasp loaded{test::degenerate_grasp(random, contacts),
                             test::small_wrench(random)};
    const auto question = random_preload_margin(random, loaded, law);
    if (question) expect_exact(*question, tally);
  }
  print("degenerate, preloads", tally);
  EXPECT_GE(tally.intervals[0], rounds(11U));
  EXPECT_GE(tally.intervals[1], rounds(11U));
  EXPECT_GE(tally.unbounded, rounds(11U));
}

TEST(Margin, EveryEndAgainstVerdictsAlongPreloadsOfGenericGrasps) {
  if (test::kSanitized) GTEST_SKIP() << "the degenerate ones run the same lines";
  RandomSource random(615);
  Tally tally;
  for (int round = 0; round < rounds(80); ++round) {
    const auto contacts = static_cast<std::size_t>(random.between(2, 6));
    const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const Grasp grasp = test::generic_grasp(random, contacts);
    const LoadedGrasp loaded{grasp, test::planted_wrench(random, grasp, law)};
    const auto question = random_preload_margin(random, loaded, law);
    if (question) expect_exact(*question, tally);
  }
  print("generic, preloads", tally);
  EXPECT_GE(tally.intervals[1], rounds(21U));
}

// An equilibrium under w with the preloads l P is, scaled by 1/l, one under w/l with P. The one
// margin knows the multiple as one more coordinate, the other only at the ends of its range.
TEST(Margin, MorePreloadIsAsLessLoad) {
  RandomSource random(616);
  std::size_t ends = 0;
  for (int round = 0; round < rounds(150); ++round) {
    const auto contacts = static_cast<std::size_t>(random.between(1, 5));
    const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    Grasp grasp = random.one_in(2) ? test::generic_grasp(random, contacts)
                                   : test::degenerate_grasp(random, contacts);
    Wrench load = random.one_in(2) ? test::planted_wrench(random, grasp, law)
                                   : test::small_wrench(random);
    if (load == Wrench{}) load.x = 1;
    std::vector<Rational> preloads;
    for (const Contact& c : grasp.contacts()) preloads.push_back(c.preload);
    preloads.front() += 1;
    try {
      grasp = grasp.with_preloads(preloads);
      const Margin of_load = margin_of(test::margin_question({grasp, {}}, law, load));
      const Margin of_preload =
          margin_of(test::margin_question({grasp, load}, law, std::nullopt, kScale));
      const auto expect_alike = [&](const Rational& factor) {
        if (factor.is_zero()) return;
        EXPECT_EQ(contains(of_load.resisted, factor),
                  contains(of_preload.resisted, 1 / factor));
        ++ends;
      };
      for (const Rational& factor : interesting_multiples(of_load.resisted)) {
        expect_alike(factor);
      }
      for (const Rational& multiple : interesting_multiples(of_preload.resisted)) {
        if (!multiple.is_zero()) expect_alike(1 / multiple);
      }
    } catch (const InputError& error) {  // a normal of irrational length
      EXPECT_EQ(error.place(), "contacts[0].normal");
    }
  }
  EXPECT_GE(ends, rounds(1001U));
}

}  // namespace
}  // namespace stickslip
