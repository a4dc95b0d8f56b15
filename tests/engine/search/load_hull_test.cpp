// SPDX-License-Identifier: GPL-3.0-or-later
// Convex sets of loads by corners and directions, against loads of them at random.
#include "stickslip/engine/load_hull.hpp"

#include <gtest/gtest.h>

#include "random_grasps.hpp"

namespace stickslip {
namespace load_hull_test {

using test::RandomSource;

LoadGenerator generator(RandomSource& random, bool is_direction) {
  LoadGenerator g;
  for (int j = 0; j < 3; ++j) g.load.emplace_back(random.between(-2, 2));
  if (is_direction && is_zero(primitive_multiple(g.load))) g.load[0] = 1;
  for (int k = 0; k < 2; ++k) g.strict.emplace_back(random.between(0, 1));
  g.rounded = Reals(3);
  for (std::size_t j = 0; j < 3; ++j) {
    g.rounded[static_cast<Eigen::Index>(j)] = to_double(g.load[j]);
  }
  return g;
}

LoadHull random_hull(RandomSource& random) {
  LoadHull hull;
  for (int k = random.between(1, 4); k > 0; --k) {
    hull.corners.push_back(generator(random, false));
  }
  for (int k = random.between(0, 2); k > 0; --k) {
    hull.directions.push_back(generator(random, true));
  }
  return hull;
}

struct Load {
  RationalRow load;
  RationalRow strict;
};

/// A load of the hull, perhaps one where a strict function vanishes.
Load random_load(RandomSource& random, const LoadHull& hull) {
  Load sum{RationalRow(3), RationalRow(2)};
  const auto add = [&](const LoadGenerator& g, const Rational& part) {
    for (std::size_t j = 0; j < 3; ++j) sum.load[j] += part * g.load[j];
    for (std::size_t k = 0; k < 2; ++k) sum.strict[k] += part * g.strict[k];
  };
  std::vector<Rational> parts;
  Rational all = 0;
  for (std::size_t k = 0; k < hull.corners.size(); ++k) {
    all += parts.emplace_back(random.one_in(2) ? 0 : random.between(1, 3));
  }
  if (all.is_zero()) all = parts.front() = 1;
  for (std::size_t k = 0; k < hull.corners.size(); ++k) add(hull.corners[k], parts[k] / all);
  for (const LoadGenerator& g : hull.directions) add(g, random.between(0, 2));
  return sum;
}

TEST(LoadHull, BoundsAndBarsAreThoseOfItsLoads) {
  RandomSource random(221);
  int barred = 0;
  int unbounded = 0;
  for (int round = 0; round < 400; ++round) {
    const LoadHull hull = random_hull(random);
    Row y(3);
    for (Integer& entry : y) entry = random.between(-2, 2);
    const RationalRow twist(y.begin(), y.end());
    Reals rounded(3);
    for (std::size_t j = 0; j < 3; ++j) {
      rounded[static_cast<Eigen::Index>(j)] = to_double(twist[j]);
    }
    const Rational most = hull.most_work(y);
    EXPECT_NEAR(hull.worst(rounded).dot(rounded), to_double(most), 1e-12);
    bool any = false;
    for (const LoadGenerator& corner : hull.corners) {
      EXPECT_LE(dot(twist, corner.load), most);
      any = any || dot(twist, corner.load) == most;
    }
    EXPECT_TRUE(any);
    bool rises = false;
    for (const LoadGenerator& g : hull.directions) {
      rises = rises || dot(twist, g.load).sign() > 0;
    }
    EXPECT_EQ(hull.is_unbounded(y), rises);
    if (rises) {
      ++unbounded;
      continue;
    }
    const bool bars = hull.bars(y, true);
    const bool bars_directions = hull.bars(y, false);
    if (bars) {
      EXPECT_TRUE(bars_directions);
    }
    barred += bars ? 1 : 0;
    bool reached = false;
    for (int sample = 0; sample < 60; ++sample) {
      const Load load = random_load(random, hull);
      const Rational work = dot(twist, load.load);
      EXPECT_LE(work, most);
      const bool is_strict = load.strict[0].sign() > 0 && load.strict[1].sign() > 0;
      reached = reached || (is_strict && work == most);
    }
    // A hull that is barred has no load without a vanishing function that does the most work.
    EXPECT_FALSE(bars && reached);
    // Else the sum of all that do the most is one, as no function vanishes on all of them.
    Load sum{RationalRow(3), RationalRow(2)};
    for (const auto* list : {&hull.corners, &hull.directions}) {
      for (const LoadGenerator& g : *list) {
        if (dot(twist, g.load) != (list == &hull.corners ? most : Rational(0))) continue;
        for (std::size_t k = 0; k < 2; ++k) sum.strict[k] += g.strict[k];
      }
    }
    EXPECT_EQ(bars, sum.strict[0].is_zero() || sum.strict[1].is_zero());
    Load without_corners{RationalRow(3), RationalRow(2)};
    for (const LoadGenerator& g : hull.directions) {
      if (!dot(twist, g.load).is_zero()) continue;
      for (std::size_t k = 0; k < 2; ++k) without_corners.strict[k] += g.strict[k];
    }
    EXPECT_EQ(bars_directions,
              without_corners.strict[0].is_zero() || without_corners.strict[1].is_zero());
  }
  EXPECT_GE(barred, 40);
  EXPECT_GE(unbounded, 40);
}

}  // namespace load_hull_test
}  // namespace stickslip
