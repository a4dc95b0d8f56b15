// SPDX-License-Identifier: GPL-3.0-or-later
// What may be done to the planes, and what it does to the states.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "families.hpp"

namespace stickslip {
namespace {

using test::Random;

/// Simple, degenerate, rank-deficient and axis-aligned planes in turn.
std::vector<Vector3> some_planes(std::uint32_t seed) {
  switch (seed % 4) {
    case 0:
      return test::simple_planes(7, seed);
    case 1:
      return test::grid_planes(12, 2, seed);
    case 2:
      return test::pencil_planes(6, seed);
    default:
      return test::axis_aligned_planes(11, 3, seed);
  }
}

constexpr std::uint32_t kSeeds = 24;

void expect_same_counts(const ArrangementCounts& a, const ArrangementCounts& b) {
  EXPECT_EQ(a.circles, b.circles);
  EXPECT_EQ(a.rank, b.rank);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.faces, b.faces);
}

TEST(Invariance, PositiveScaling) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    std::vector<Vector3> planes = some_planes(seed);
    const SlipStates before = enumerate_slip_states_cgal(planes);
    Random random(seed);
    for (Vector3& n : planes) {
      const Rational factor(random.between(1, 99), random.between(1, 99));
      for (Rational& entry : n) entry *= factor;
    }
    EXPECT_EQ(enumerate_slip_states_cgal(planes).states, before.states);
  }
}

TEST(Invariance, Permutation) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const std::vector<Vector3> planes = some_planes(seed);
    std::vector<std::size_t> order(planes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Random random(seed);
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1],
                order[static_cast<std::size_t>(random.between(0, static_cast<int>(i) - 1))]);
    }
    std::vector<Vector3> permuted;
    for (const std::size_t i : order) permuted.push_back(planes[i]);

    const SlipStates before = enumerate_slip_states_cgal(planes);
    std::vector<std::string> expected;
    for (const SlipState& state : before.states) {
      SlipState moved;
      for (const std::size_t i : order) moved.push_back(state[i]);
      expected.push_back(to_string(moved));
    }
    std::sort(expected.begin(), expected.end());
    const SlipStates after = enumerate_slip_states_cgal(permuted);
    EXPECT_EQ(test::texts(after.states), expected);
    expect_same_counts(after.counts, before.counts);
  }
}

TEST(Invariance, NegatingAPlaneFlipsItsSign) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    std::vector<Vector3> planes = some_planes(seed);
    const SlipStates before = enumerate_slip_states_cgal(planes);
    const std::size_t negated = seed % planes.size();
    for (Rational& entry : planes[negated]) entry = -entry;
    std::vector<std::string> expected;
    for (SlipState state : before.states) {
      state[negated] = -state[negated];
      expected.push_back(to_string(state));
    }
    std::sort(expected.begin(), expected.end());
    const SlipStates after = enumerate_slip_states_cgal(planes);
    EXPECT_EQ(test::texts(after.states), expected);
    expect_same_counts(after.counts, before.counts);
  }
}

// n.d = (Mn).(M^-T d) for any regular M, also one that reverses orientation.
TEST(Invariance, LinearMapsOfTheSphere) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const std::vector<Vector3> planes = some_planes(seed);
    const SlipStates before = enumerate_slip_states_cgal(planes);
    Random random(seed);
    for (int round = 0; round < 3; ++round) {
      const Vector3 rows[] = {random.vector(5), random.vector(5), random.vector(5)};
      const Rational determinant =
          rows[0][0] * (rows[1][1] * rows[2][2] - rows[1][2] * rows[2][1]) -
          rows[0][1] * (rows[1][0] * rows[2][2] - rows[1][2] * rows[2][0]) +
          rows[0][2] * (rows[1][0] * rows[2][1] - rows[1][1] * rows[2][0]);
      if (determinant == 0) continue;
      std::vector<Vector3> mapped;
      for (const Vector3& n : planes) {
        Vector3 image;
        for (std::size_t i = 0; i < 3; ++i) {
          image[i] = rows[i][0] * n[0] + rows[i][1] * n[1] + rows[i][2] * n[2];
        }
        mapped.push_back(image);
      }
      const SlipStates after = enumerate_slip_states_cgal(mapped);
      EXPECT_EQ(after.states, before.states);
      expect_same_counts(after.counts, before.counts);
    }
  }
}

TEST(Invariance, RepeatingAPlaneRepeatsItsSign) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    std::vector<Vector3> planes = some_planes(seed);
    const SlipStates before = enumerate_slip_states_cgal(planes);
    const std::size_t repeated = seed % planes.size();
    planes.push_back(planes[repeated]);
    const SlipStates after = enumerate_slip_states_cgal(planes);
    ASSERT_EQ(after.states.size(), before.states.size());
    for (std::size_t i = 0; i < before.states.size(); ++i) {
      SlipState expected = before.states[i];
      expected.push_back(expected[repeated]);
      EXPECT_EQ(after.states[i], expected);
    }
    expect_same_counts(after.counts, before.counts);
  }
}

TEST(Invariance, ResultsAreWellFormed) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    test::expect_well_formed(enumerate_slip_states_cgal(some_planes(seed)));
  }
}

}  // namespace
}  // namespace stickslip
