// SPDX-License-Identifier: GPL-3.0-or-later
// Classes of all factors of friction: against the class at each, and closed forms.
#include "stickslip/earlier/friction_margin.hpp"

#include <gtest/gtest.h>

#include <set>

#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::RandomSource;

std::vector<FactorRange> factors(const Grasp& grasp, const Wrench& w,
                                 const Inertia& inertia = {}) {
  return friction_margin(Problem({grasp, w}, NormalLaw::kUnilateral), inertia);
}

Grasp with_friction_times(const Grasp& grasp, const Rational& s) {
  std::vector<Contact> contacts = grasp.contacts();
  for (Contact& contact : contacts) contact.friction *= s;
  return Grasp(contacts);
}

bool contains(const FactorRange& range, const Rational& s) {
  return (range.low < s || (range.has_low && range.low == s)) &&
         (!range.high || s < *range.high || (range.has_high && s == *range.high));
}

// At the ends, beside them and between them; and the ranges are all factors, each once.
TEST(FrictionMargin, IsTheClassOfEachFactor) {
  RandomSource random(82);
  std::set<std::string> seen;
  int exact = 0, known = 0;
  for (int round = 0; round < 120; ++round) {
    const auto m = static_cast<std::size_t>(random.between(1, 4));
    const Grasp grasp =
        round % 3 == 0 ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
    Wrench w = test::small_wrench(random);
    const Inertia inertia{{random.between(-2, 2), 0}, {{Rational(random.between(1, 40), 20)}}};
    const std::vector<FactorRange> ranges = factors(grasp, w, inertia);
    ASSERT_TRUE(ranges.front().low.is_zero() && ranges.front().has_low);
    ASSERT_FALSE(ranges.back().high);
    std::set<Rational> asked{0, 1, Rational(7, 3), 1000};
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      if (k > 0) {
        ASSERT_EQ(*ranges[k - 1].high, ranges[k].low);
        ASSERT_NE(ranges[k - 1].has_high, ranges[k].has_low);
      }
      for (const Rational& off : {Rational(0), parse_rational("1e-9"), Rational(1, 2)}) {
        asked.insert(ranges[k].low + off);
        if (ranges[k].low > off) asked.insert(ranges[k].low - off);
      }
    }
    for (const Rational& s : asked) {
      const std::string found = name_of(rigid_verdict(
          Problem({with_friction_times(grasp, s), w}, NormalLaw::kUnilateral), inertia));
      for (const FactorRange& range : ranges) {
        if (!contains(range, s)) continue;
        if (!range.rigid_class) {
          EXPECT_NE(s, 1) << round;
          continue;
        }
        EXPECT_EQ(to_string(*range.rigid_class), found) << round << ", s = " << to_string(s);
        seen.insert(found);
        ++known;
      }
    }
    exact += ranges[0].rigid_class == RigidClass::kMustMove && ranges.size() > 1 &&
                     ranges[1].rigid_class
                 ? 1
                 : 0;
  }
  EXPECT_EQ(seen.size(), 3u);
  EXPECT_GT(known, 500);
  EXPECT_GT(exact, 10);
}

// A block that tips, whatever the friction.
TEST(FrictionMargin, NoFactorHoldsWhatTips) {
  const Grasp block({{{-1, -2}, {0, 1}, 1, 1, 0}, {{1, -2}, {0, 1}, 1, 1, 0}});
  const std::vector<FactorRange> ranges = factors(block, {1, -1, 0});
  ASSERT_EQ(ranges.size(), 1u);
  EXPECT_EQ(ranges[0].rigid_class, RigidClass::kMustMove);
}

// Two walls that lean towards each other by atan(3/4) above a wedge, which is pulled up or
// turned out of them: it stays, jammed, only if mu > 3/4, and then whatever the force; at 3/4
// not yet.
TEST(FrictionMargin, OfAWedgeThatJams) {
  const Grasp wedge(
      {{{-1, 0}, {4, 3}, Rational(1, 4), 1, 0}, {{1, 0}, {-4, 3}, Rational(1, 4), 1, 0}});
  const std::vector<FactorRange> ranges = factors(wedge, {0, 1, 0});
  ASSERT_GE(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].rigid_class, RigidClass::kMustMove);
  EXPECT_EQ(*ranges[0].high, 3);
  EXPECT_TRUE(ranges[0].has_high);
}

// A ladder from the wall at (0, 4) to the floor at (3, 0), with its load at the middle, and the
// same friction mu at both ends, slides until 2 atan(mu) is the angle to the upright: mu is
// irrational for 3 : 4, and 1/3 for a foot at 3 as (1 - mu^2) / (2 mu) = 4/3.
TEST(FrictionMargin, OfALadder) {
  for (const Rational& foot : {Rational(3), Rational(2)}) {
    const Grasp ladder({{{0, 4}, {1, 0}, 1, 1, 0}, {{foot, 0}, {0, 1}, 1, 1, 0}});
    const std::vector<FactorRange> ranges = factors(ladder, {0, -1, -foot / 2});
    ASSERT_EQ(ranges[0].rigid_class, RigidClass::kMustMove);
    const auto slides = [&](const Rational& mu) { return foot * (1 - mu * mu) > 2 * mu * 4; };
    if (foot == 3) {
      EXPECT_EQ(*ranges[0].high, Rational(1, 3));
      EXPECT_FALSE(ranges[0].has_high);
      EXPECT_TRUE(ranges[1].rigid_class.has_value());
    } else {
      EXPECT_TRUE(slides(*ranges[0].high));
      ASSERT_FALSE(ranges[1].rigid_class);
      EXPECT_FALSE(slides(*ranges[1].high));
      EXPECT_LT((*ranges[1].high - ranges[1].low) * 1000000, *ranges[1].high);
    }
  }
}

TEST(FrictionMargin, RefusesWhatMeansNothing) {
  const Problem problem({Grasp({{{0, 0}, {0, 1}, 1, 1, 0}}), {0, -1, 0}},
                        NormalLaw::kUnilateral);
  EXPECT_THROW(friction_margin(problem, {{0, 0}, {{0}}}), ContractError);
  EXPECT_THROW(friction_margin(problem, {}, 0), ContractError);
}

}  // namespace
}  // namespace stickslip
