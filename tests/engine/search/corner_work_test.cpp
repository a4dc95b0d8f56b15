// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of the work of a contact with uncertain geometry, against Bernstein coefficients by
// their definition and against forces at random places of the cube.
#include "stickslip/engine/corner_work.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "random_grasps.hpp"
#include "stickslip/core/number.hpp"
#include "stickslip/core/row.hpp"

namespace stickslip {
namespace corner_work_test {

using test::RandomSource;

/// Returns how many ones the number k has in base 2 at the place of each dimension.
std::vector<int> digits(std::size_t a, std::size_t b, std::size_t dimensions) {
  std::vector<int> sum;
  for (std::size_t k = 0; k < dimensions; ++k) {
    sum.push_back(static_cast<int>((a >> k & 1) + (b >> k & 1)));
  }
  return sum;
}

TEST(CornerPairs, CellsHaveThePairsWithOneSumOfCorners) {
  for (std::size_t dimensions = 0; dimensions < 4; ++dimensions) {
    const std::size_t corners = std::size_t{1} << dimensions;
    const CornerPairs& pairs = CornerPairs::of(corners);
    ASSERT_EQ(pairs.corners, corners);
    ASSERT_EQ(pairs.cell.size(), corners * corners);
    std::vector<std::size_t> count(pairs.cells);
    for (std::size_t one = 0; one < pairs.cell.size(); ++one) {
      ++count[pairs.cell[one]];
      for (std::size_t other = 0; other < pairs.cell.size(); ++other) {
        const bool same = digits(one / corners, one % corners, dimensions) ==
                          digits(other / corners, other % corners, dimensions);
        EXPECT_EQ(pairs.cell[one] == pairs.cell[other], same);
      }
    }
    for (std::size_t k = 0; k < pairs.cells; ++k) {
      EXPECT_EQ(pairs.share[k] * count[k], corners);
    }
  }
}

/// A contact: its springs, and alpha by slope and corner.
struct Case {
  std::size_t dimensions;
  SpringEnds<Rational> ends;
  std::vector<std::vector<Rational>> alpha;
  Rational h;
  std::vector<Rational> rises;

  std::size_t corners() const { return std::size_t{1} << dimensions; }
};

Rational small(RandomSource& random) {
  return {random.between(-6, 6), random.between(1, 3)};
}

Case random_case(RandomSource& random) {
  Case c{static_cast<std::size_t>(random.between(0, 3)), {}, {}, random.between(0, 2), {}};
  const Rational preload(random.between(0, 4), 2);
  const Rational stiffness(random.between(1, 4), 2);
  c.ends = {{preload, preload + random.between(0, 1)}, {stiffness, stiffness + 1}};
  const int offset = random.between(-6, 6);
  c.alpha.resize(static_cast<std::size_t>(random.between(1, 2)));
  for (std::size_t k = 0; k < c.corners(); ++k) {
    for (std::vector<Rational>& of : c.alpha) of.push_back(small(random) + offset);
    c.rises.push_back(small(random));
  }
  return c;
}

/// Returns the value at a place of the cube of the multilinear function with these values at
/// the corners.
Rational at_place(const std::vector<Rational>& values, const std::vector<Rational>& place) {
  Rational sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    Rational weight = 1;
    for (std::size_t d = 0; d < place.size(); ++d) {
      weight *= (k >> d & 1) == 1 ? place[d] : Rational(1 - place[d]);
    }
    sum += weight * values[k];
  }
  return sum;
}

/// Returns the largest Bernstein coefficient of alpha v for these ends of the springs.
Rational largest_coefficient(const Case& c, const std::vector<Rational>& alpha,
                             const Rational& preload, const Rational& stiffness) {
  std::optional<Rational> most;
  for (std::size_t cell = 0; cell < CornerPairs::of(c.corners()).cells; ++cell) {
    std::vector<int> wanted;
    for (std::size_t rest = cell; wanted.size() < c.dimensions; rest /= 3) {
      wanted.push_back(static_cast<int>(rest % 3));
    }
    Rational sum = 0;
    int count = 0;
    for (std::size_t a = 0; a < c.corners(); ++a) {
      for (std::size_t b = 0; b < c.corners(); ++b) {
        if (digits(a, b, c.dimensions) != wanted) continue;
        sum += alpha[a] * (c.h * preload - stiffness * c.rises[b]);
        ++count;
      }
    }
    sum /= count;
    if (!most || sum > *most) most = sum;
  }
  return *most;
}

// A contact that is closed has the largest Bernstein coefficient, over slopes and ends. One
// that may be open has the same where it can only push along the twist, the product of the
// largest alpha and the largest v where it can push along and against it, and else nothing.
TEST(CornerWork, BoundsAreThoseOfTheFormat) {
  RandomSource random(211);
  int products = 0;
  int nothing = 0;
  for (int round = 0; round < 400; ++round) {
    const Case c = random_case(random);
    for (const bool mixed : {false, true}) {
      std::optional<Rational> expected;
      if (mixed) expected = 0;
      for (const std::vector<Rational>& alpha : c.alpha) {
        const Rational most = *std::max_element(alpha.begin(), alpha.end());
        const bool falls = *std::min_element(alpha.begin(), alpha.end()) < 0;
        if (mixed && !(most > 0)) continue;
        for (const Rational& preload : c.ends.preloads) {
          for (const Rational& stiffness : c.ends.stiffnesses) {
            const Rational v =
                c.h * preload - stiffness * *std::min_element(c.rises.begin(), c.rises.end());
            const Rational bound = mixed && falls
                                       ? Rational(most * std::max(v, Rational(0)))
                                       : largest_coefficient(c, alpha, preload, stiffness);
            if (!expected || bound > *expected) expected = bound;
          }
        }
      }
      const CornerWork<Rational> work(c.ends, c.alpha, mixed);
      const Strongest<Rational> found = work.at(c.h, c.rises.data());
      EXPECT_EQ(found.bound, *expected * static_cast<long>(c.corners()));
      products += found.product ? 1 : 0;
      nothing += found.friction == 2 ? 1 : 0;
      EXPECT_EQ(found.friction == 2, mixed && expected->is_zero());
    }
  }
  EXPECT_GE(products, 30);
  EXPECT_GE(nothing, 30);
}

// No force of any grasp does more work than the bound, wherever in the cube its geometry is.
TEST(CornerWork, NoForceDoesMoreWork) {
  RandomSource random(212);
  for (int round = 0; round < 300; ++round) {
    const Case c = random_case(random);
    for (const bool mixed : {false, true}) {
      const CornerWork<Rational> work(c.ends, c.alpha, mixed);
      const Rational bound = work.at(c.h, c.rises.data()).bound;
      for (int sample = 0; sample < 8; ++sample) {
        std::vector<Rational> place;
        while (place.size() < c.dimensions) place.emplace_back(random.between(0, 4), 4);
        const Rational part(random.between(0, 3), 3);
        const auto& [low, high] = c.ends.preloads;
        const std::size_t end = random.one_in(2) ? 1 : 0;
        Rational v = c.h * (low + part * (high - low)) -
                     c.ends.stiffnesses[end] * at_place(c.rises, place);
        if (mixed && v < 0) v = 0;
        for (const std::vector<Rational>& alpha : c.alpha) {
          EXPECT_LE(at_place(alpha, place) * v * static_cast<long>(c.corners()), bound);
        }
      }
    }
  }
}

// Doubles propose the same force as exact numbers, and say when its sign is in doubt.
TEST(CornerWork, DoublesAgree) {
  RandomSource random(213);
  for (int round = 0; round < 200; ++round) {
    const Case c = random_case(random);
    SpringEnds<double> ends{};
    std::vector<std::vector<double>> alpha(c.alpha.size());
    std::vector<double> rises;
    double least = 100;
    bool pushes = false;
    for (std::size_t end = 0; end < 2; ++end) {
      ends.preloads[end] = to_double(c.ends.preloads[end]);
      ends.stiffnesses[end] = to_double(c.ends.stiffnesses[end]);
    }
    for (std::size_t s = 0; s < alpha.size(); ++s) {
      for (const Rational& value : c.alpha[s]) {
        alpha[s].push_back(to_double(value));
        least = std::min(least, std::abs(alpha[s].back()));
        pushes = pushes || value > 0;
      }
    }
    for (const Rational& rise : c.rises) rises.push_back(to_double(rise));
    for (const bool mixed : {false, true}) {
      const CornerWork<double> work(ends, alpha, mixed);
      const Rational exact =
          CornerWork<Rational>(c.ends, c.alpha, mixed).at(c.h, c.rises.data()).bound;
      EXPECT_NEAR(work.at(to_double(c.h), rises.data()).bound, to_double(exact), 1e-9);
      EXPECT_EQ(work.pushes(), pushes);
      EXPECT_TRUE(least == 0 || work.is_clear(least / 2));
      EXPECT_FALSE(work.is_clear(least));
    }
  }
}

}  // namespace corner_work_test
}  // namespace stickslip
