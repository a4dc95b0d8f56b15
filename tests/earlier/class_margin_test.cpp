// SPDX-License-Identifier: GPL-3.0-or-later
// Classes of all multiples of a load: against the class of each, and closed forms.
#include "stickslip/earlier/class_margin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::RandomSource;

std::vector<ClassRange> classes(const Grasp& grasp, const Wrench& w, const Wrench& u,
                                const Inertia& inertia = {}) {
  const Problem family = Problem({grasp, w}, NormalLaw::kUnilateral).along({row_of(u)});
  auto result = class_margin(family, inertia);
  return std::get<std::vector<ClassRange>>(std::move(result));
}

std::string class_at(const std::vector<ClassRange>& ranges, const Rational& l) {
  for (const ClassRange& range : ranges) {
    if (!range.high || l < *range.high || (range.has_high && l == *range.high)) {
      return to_string(range.rigid_class);
    }
  }
  return "none";
}

// At the ends, beside them and between them.
TEST(ClassMargin, IsTheClassOfEachMultiple) {
  RandomSource random(81);
  std::set<std::string> seen;
  int gaps = 0;
  for (int round = 0; round < 150; ++round) {
    const auto m = static_cast<std::size_t>(random.between(0, 4));
    const Grasp grasp =
        round % 3 == 0 ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
    const Wrench w = round % 2 == 0 ? Wrench{} : test::small_wrench(random);
    Wrench u = test::small_wrench(random);
    if (u == Wrench{}) u = {1, -1, 0};
    const Inertia inertia{{random.between(-2, 2), Rational(random.between(-3, 3), 2)},
                          {{Rational(random.between(1, 40), 20)}}};
    const std::vector<ClassRange> ranges = classes(grasp, w, u, inertia);
    std::set<Rational> asked{0, 1, Rational(7, 3), 1000};
    for (const ClassRange& range : ranges) {
      for (const Rational& off : {Rational(0), parse_rational("1e-9"), Rational(1, 2)}) {
        asked.insert(range.low + off);
        if (range.low > off) asked.insert(range.low - off);
      }
    }
    const Problem base({grasp, {}}, NormalLaw::kUnilateral);
    for (const Rational& l : asked) {
      const std::string found = name_of(rigid_verdict(base.with_wrench(w + l * u), inertia));
      EXPECT_EQ(class_at(ranges, l), found) << round << ", l = " << to_string(l);
      seen.insert(found);
    }
    EXPECT_TRUE(ranges.front().low.is_zero() && ranges.front().has_low);
    EXPECT_FALSE(ranges.back().high);
    gaps += ranges.size() > 2 ? 1 : 0;
  }
  EXPECT_EQ(seen.size(), 3u);
  EXPECT_GT(gaps, 5);
}

// A ladder from the wall at (0, 4) to the floor at (3, 0), with a load of 1 at the share s of
// the way up.
TEST(ClassMargin, OfALadder) {
  const Rational mu(2, 5);
  const Grasp ladder({{{0, 4}, {1, 0}, mu, 1, 0}, {{3, 0}, {0, 1}, mu, 1, 0}});
  // At the limit the foot slides out and the top down: with foot normal n, wall normal mu n,
  // n (1 + mu^2) = 1; moments about the foot: 3 s = 4 mu n + 3 mu (mu n).
  const Rational n = 1 / (1 + mu * mu);
  const Rational limit = (4 * mu * n + 3 * mu * mu * n) / 3;
  ASSERT_LT(limit, 1);
  // The load at x = 3 - 3 s has the torque -3 + 3 s.
  const std::vector<ClassRange> ranges = classes(ladder, {0, -1, -3}, {0, 0, 3}, {});
  ASSERT_GE(ranges.size(), 2u);
  EXPECT_EQ(ranges.back().rigid_class, RigidClass::kMustMove);
  EXPECT_EQ(ranges.back().low, limit);
  EXPECT_FALSE(ranges.back().has_low);
}

TEST(ClassMargin, KeepsTheLimit) {
  const Problem family =
      Problem({Grasp({{{0, 0}, {0, 1}, 1, 1, 0}}), {0, -1, 0}}, NormalLaw::kUnilateral)
          .along({{1, 0, 0}});
  EXPECT_TRUE(std::holds_alternative<Undecided>(class_margin(family, {}, 3)));
  EXPECT_THROW(class_margin(family, {{0, 0}, {{0}}}), ContractError);
}

}  // namespace
}  // namespace stickslip
