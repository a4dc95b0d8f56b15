// SPDX-License-Identifier: GPL-3.0-or-later
// Margins along loads and preloads: the paper's thresholds, and every end against verdicts at
// it and beside it.
#include "stickslip/measures/margin.hpp"

#include <gtest/gtest.h>

#include <functional>
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
  EXPECT_THROW(branch_and_bound(family), ContractError);
  EXPECT_THROW(find_violation(family, {}), ContractError);
}

TEST(Margin, StopsAtTheNodeLimit) {
  const Problem problem(LoadedGrasp{test::fig1_grasp(1), {}}, NormalLaw::kUnilateral);
  SearchOptions options;
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

Question degenerate_question(RandomSource& random) {
  const auto contacts = static_cast<std::size_t>(random.between(0, 4));
  const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  LoadedGrasp loaded{test::degenerate_grasp(random, contacts), {}};
  if (!random.one_in(3)) loaded.wrench = test::small_wrench(random);
  Wrench direction = test::small_wrench(random);
  if (direction == Wrench{}) direction.x = 1;
  return test::margin_question(loaded, law, direction);
}

Question generic_question(RandomSource& random) {
  const auto contacts = static_cast<std::size_t>(random.between(2, 6));
  const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  const Grasp grasp = test::generic_grasp(random, contacts);
  const Wrench wrench = test::planted_wrench(random, grasp, law);
  // Half of the directions pass through a second stable load.
  Wrench direction = test::small_wrench(random);
  if (random.one_in(2)) {
    direction = test::planted_wrench(random, grasp, law) + Rational(-1) * wrench;
  }
  if (direction == Wrench{}) direction.torque = 1;
  return test::margin_question({grasp, wrench}, law, direction);
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
    growth.preloads.emplace_back(may ? random.between(sum.is_zero() ? 1 : 0, 2) : 0);
    sum += growth.preloads.back();
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

std::optional<Question> preloads_of_degenerate_grasp(RandomSource& random) {
  const auto contacts = static_cast<std::size_t>(random.between(1, 4));
  const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  const Grasp grasp = test::degenerate_grasp(random, contacts);
  return random_preload_margin(random, {grasp, test::small_wrench(random)}, law);
}

std::optional<Question> preloads_of_generic_grasp(RandomSource& random) {
  const auto contacts = static_cast<std::size_t>(random.between(2, 6));
  const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  const Grasp grasp = test::generic_grasp(random, contacts);
  return random_preload_margin(random, {grasp, test::planted_wrench(random, grasp, law)}, law);
}

TEST(Margin, EveryEndAgainstVerdicts) {
  const struct {
    const char* family;
    std::uint64_t seed;
    int count;
    std::function<std::optional<Question>(RandomSource&)> make;
    bool degenerate;
  } families[] = {{"degenerate", 611, 120, degenerate_question, true},
                  {"generic", 612, 80, generic_question, false},
                  {"degenerate, preloads", 614, 160, preloads_of_degenerate_grasp, true},
                  {"generic, preloads", 615, 80, preloads_of_generic_grasp, false}};
  for (const auto& [family, seed, count, make, degenerate] : families) {
    if (test::kSanitized && !degenerate) continue;  // the degenerate ones run the same lines
    RandomSource random(seed);
    Tally tally;
    for (int round = 0; round < rounds(count); ++round) {
      const std::optional<Question> question = make(random);
      if (question) expect_exact(*question, tally);
    }
    print(family, tally);
    EXPECT_GE(tally.intervals[1], rounds(degenerate ? 11U : 21U)) << family;
    EXPECT_GE(tally.intervals[0], degenerate ? rounds(11U) : 0U) << family;
    EXPECT_GE(tally.unbounded, degenerate ? rounds(11U) : 0U) << family;
  }
}

}  // namespace
}  // namespace stickslip
