// SPDX-License-Identifier: GPL-3.0-or-later
// Statics: beside linear programs of one body, whose loads are often on a border; and its own
// evidence, by substitution.
#include "stickslip/earlier/statics.hpp"

#include <gtest/gtest.h>

#include "random_grasps.hpp"
#include "rounds.hpp"

namespace stickslip {
namespace {

using test::RandomSource;

GraspBox box_of(const Grasp& grasp, const Wrench& wrench) {
  return stickslip::box_of(LoadedGrasp{grasp, wrench});
}

TEST(Statics, OfOneBodyInThePlaneIsWeakStability) {
  RandomSource random(91);
  int balanced = 0;
  const int count = test::rounds(600);
  for (int round = 0; round < count; ++round) {
    const auto m = static_cast<std::size_t>(random.between(0, 6));
    const Grasp grasp =
        round % 3 == 0 ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
    const Wrench w = round % 2 == 0
                         ? test::small_wrench(random)
                         : test::planted_wrench(random, grasp, NormalLaw::kUnilateral);
    const bool is_weak = std::holds_alternative<RigidForces>(
        weakly_stable_load(Problem({grasp, w}, NormalLaw::kUnilateral)));
    const LoadClass found = statics(box_of(grasp, w));
    EXPECT_EQ(found.index(), is_weak ? 0 : 1) << round;
    balanced += is_weak ? 1 : 0;
  }
  EXPECT_GT(balanced, count / 5);
  EXPECT_LT(balanced, count * 4 / 5);
}

// Friction that is just what is needed, and less or more by a millionth.
TEST(Statics, OnTheBorderOfFriction) {
  RandomSource random(92);
  int enclosed = 0;
  for (int round = 0; round < test::rounds(120); ++round) {
    const Grasp grasp = test::generic_grasp(random, 4);
    const GraspBox box = box_of(grasp, test::small_wrench(random));
    const auto least = least_friction(box);
    const auto* found = std::get_if<LeastFriction>(&least);
    if (found == nullptr) {
      EXPECT_TRUE(std::holds_alternative<UnopposedMotion>(least)) << round;
      EXPECT_EQ(statics(box, 1000).index(), 1) << round;
      continue;
    }
    EXPECT_LE(found->high - found->low,
              Rational(1, 1000000) * std::max<Rational>(found->high, Rational(1, 1000000)));
    EXPECT_EQ(statics(box, found->high).index(), 0) << round;
    if (found->low.is_zero()) continue;
    EXPECT_EQ(statics(box, found->low).index(), 1) << round;
    ++enclosed;
  }
  EXPECT_GT(enclosed, 5);
}

// The ends of a line of loads may stand, and loads just beyond them must move.
TEST(Statics, TheEndsOfALineAreExactInThePlane) {
  RandomSource random(93);
  int ends = 0;
  for (int round = 0; round < test::rounds(150); ++round) {
    const Grasp grasp =
        test::degenerate_grasp(random, static_cast<std::size_t>(random.between(1, 5)));
    const Wrench w = test::small_wrench(random);
    Wrench u = test::small_wrench(random);
    if (u == Wrench{}) u = {1, -1, 0};
    const GraspBox box = box_of(grasp, w);
    const StandingLoads loads = standing_loads(box, {row_of(u)});
    const StandingMultiples found = multiples_of(box, loads, row_of(u));
    const auto stands = [&](const Rational& l) {
      return statics(box_of(grasp, w + l * u)).index() == 0;
    };
    EXPECT_TRUE(loads.is_exact) << round;
    if (!found.any) {
      EXPECT_TRUE(found.always_moves) << round;
      for (const int l : {-3, 0, 1, 50}) EXPECT_FALSE(stands(l)) << round;
      continue;
    }
    const Rational tiny = parse_rational("1e-20");
    EXPECT_EQ(found.low, found.below) << round;
    EXPECT_EQ(found.high, found.above) << round;
    for (const auto& [end, sign] : {std::pair(found.low, -1), {found.high, 1}}) {
      if (!end) {
        EXPECT_TRUE(stands(sign * 1000000)) << round;
        continue;
      }
      EXPECT_TRUE(stands(*end)) << round;
      EXPECT_FALSE(stands(*end + sign * tiny)) << round;
      ++ends;
    }
  }
  EXPECT_GT(ends, 20);
}

// In a plane of loads those on a ray stand up to where the ray leaves the hull.
TEST(Statics, ThePlaneOfForcesAgreesWithItsRays) {
  RandomSource random(94);
  for (int round = 0; round < test::rounds(40); ++round) {
    const Grasp grasp =
        test::degenerate_grasp(random, static_cast<std::size_t>(random.between(2, 5)));
    const Wrench w = test::small_wrench(random);
    const GraspBox box = box_of(grasp, w);
    const StandingLoads loads = standing_loads(box, {{1, 0, 0}, {0, 1, 0}});
    EXPECT_TRUE(loads.is_exact && loads.is_complete) << round;
    for (int probe = 0; probe < 12; ++probe) {
      const Rational s(random.between(-12, 12), 4);
      const Rational t(random.between(-12, 12), 4);
      bool moves = false;
      const RationalRow load = row_of(w + Wrench{s, t, 0});
      for (const RationalRow& y : loads.move) moves = moves || dot(y, load).sign() > 0;
      const bool stands = statics(box_of(grasp, w + Wrench{s, t, 0})).index() == 0;
      // An empty set may have no motion that excludes all of it at once.
      if (!loads.stand.empty()) {
        EXPECT_EQ(stands, !moves) << round;
      }
      if (moves) {
        EXPECT_FALSE(stands) << round;
      }
    }
  }
}

}  // namespace
}  // namespace stickslip
