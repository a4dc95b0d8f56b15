// SPDX-License-Identifier: GPL-3.0-or-later
// Load margins: the paper's thresholds, and every end against verdicts at it and beside it.
#include "stickslip/equilibrium/margin.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "both_checkers.hpp"
#include "judged.hpp"
#include "paper_grasps.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::LoadCase;
using test::RandomSource;

std::string describe(const std::vector<LoadInterval>& resisted) {
  std::string text;
  for (const LoadInterval& interval : resisted) {
    text += "[" + to_string(interval.low) + ", " +
            (interval.high ? to_string(*interval.high) : "oo") + "] ";
  }
  return text;
}

Margin margin_of(const LoadCase& load_case, const Wrench& direction) {
  const Problem problem(load_case.loaded, load_case.law);
  return std::get<Margin>(find_margin(problem, direction));
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
  EXPECT_THROW(find_margin(problem, {}), ContractError);
}

TEST(Margin, StopsAtTheNodeLimit) {
  const Problem problem(LoadedGrasp{test::fig1_grasp(1), {}}, NormalLaw::kUnilateral);
  ConeOptions options;
  options.node_limit = 3;
  MarginWork work;
  EXPECT_TRUE(
      std::holds_alternative<Undecided>(find_margin(problem, {0, 1, 0}, options, &work)));
  EXPECT_LE(work.cone.nodes, 3U);
}

bool contains(const std::vector<LoadInterval>& resisted, const Rational& multiple) {
  for (const LoadInterval& interval : resisted) {
    if (multiple >= interval.low && (!interval.high || multiple <= *interval.high)) return true;
  }
  return false;
}

/// Ends, points just beside them, middles, and round numbers.
std::set<Rational> interesting_multiples(const std::vector<LoadInterval>& resisted) {
  const Rational tiny = parse_rational("1e-15");
  std::set<Rational> multiples{0, tiny, Rational(1, 3), 1, 2, 5, 1000000};
  Rational before = 0;
  const auto add_end = [&](const Rational& end) {
    multiples.insert({end, end + tiny, (before + end) / 2});
    if (end > tiny) multiples.insert(end - tiny);
    before = end;
  };
  for (const LoadInterval& interval : resisted) {
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

void expect_exact(const LoadCase& load_case, const Wrench& direction, Tally& tally) {
  const Margin margin = margin_of(load_case, direction);
  SCOPED_TRACE(describe(load_case) + " direction " + to_string(direction.x) + " " +
               to_string(direction.y) + " " + to_string(direction.torque) + ": " +
               describe(margin.resisted));
  test::expect_accepted_by_both(Question{load_case.loaded, load_case.law, std::nullopt},
                                margin);
  for (const Rational& multiple : interesting_multiples(margin.resisted)) {
    LoadCase there = load_case;
    there.loaded.wrench += multiple * direction;
    EXPECT_EQ(test::judged_verdict(there),
              contains(margin.resisted, multiple) ? "stable" : "unstable")
        << "at " << to_string(multiple);
    ++tally.verdicts;
  }
  ++tally.intervals[std::min<std::size_t>(margin.resisted.size(), 3)];
  for (const LoadInterval& interval : margin.resisted) {
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
  for (int round = 0; round < 120; ++round) {
    const auto contacts = static_cast<std::size_t>(random.between(0, 4));
    LoadCase load_case;
    load_case.law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    load_case.loaded.grasp = test::degenerate_grasp(random, contacts);
    if (!random.one_in(3)) load_case.loaded.wrench = test::small_wrench(random);
    Wrench direction = test::small_wrench(random);
    if (direction == Wrench{}) direction.x = 1;
    expect_exact(load_case, direction, tally);
  }
  print("degenerate", tally);
  EXPECT_GT(tally.intervals[0], 10U);
  EXPECT_GT(tally.intervals[1], 10U);
  EXPECT_GT(tally.unbounded, 10U);
}

TEST(Margin, EveryEndAgainstVerdictsOnGenericGrasps) {
  RandomSource random(612);
  Tally tally;
  for (int round = 0; round < 80; ++round) {
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
    expect_exact(load_case, direction, tally);
  }
  print("generic", tally);
  EXPECT_GT(tally.intervals[1], 20U);
}

TEST(Margin, ScalesWithTheDirectionAndShiftsWithTheBase) {
  RandomSource random(613);
  for (int round = 0; round < 40; ++round) {
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
      const LoadInterval& interval = margin.resisted[k];
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

}  // namespace
}  // namespace stickslip
