// SPDX-License-Identifier: GPL-3.0-or-later
// Counts that can be derived by hand, and the paper's Table II.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "families.hpp"
#include "stickslip/arrangement/slip_states.hpp"

namespace stickslip {
namespace {

using test::expect_well_formed;
using test::texts;
using ::testing::ElementsAre;

struct Counts {
  std::size_t vertices, edges, faces, states;
};

void expect_counts(const SlipStates& result, const Counts& expected) {
  EXPECT_EQ(result.counts.vertices, expected.vertices);
  EXPECT_EQ(result.counts.edges, expected.edges);
  EXPECT_EQ(result.counts.faces, expected.faces);
  EXPECT_EQ(result.counts.distinct_states, expected.states);
  expect_well_formed(result);
}

// Paper, Table II. The states column is not in the paper: 3^2 at m = 2, where the two
// vertices are both all-stick, and cells + 1 from m = 3.
TEST(Counts, TableII) {
  const std::size_t cells[] = {10, 26, 50, 82, 122, 170, 226, 290};
  const std::size_t states[] = {9, 27, 51, 83, 123, 171, 227, 291};
  for (std::size_t m = 2; m <= 9; ++m) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      const SlipStates result = enumerate_slip_states_cgal(test::simple_planes(m, seed));
      EXPECT_EQ(result.counts.cells(), cells[m - 2]);
      EXPECT_EQ(result.counts.distinct_states, states[m - 2]);
      expect_well_formed(result);
    }
  }
}

TEST(Counts, Fig4Grasp) {
  const SlipStates result = enumerate_slip_states_cgal(stick_planes(test::fig4_grasp()));
  expect_counts(result, {2, 4, 4, 9});
  EXPECT_EQ(result.counts.cells(), 10u);
  EXPECT_EQ(result.counts.planes, 4u);
  EXPECT_EQ(result.counts.circles, 2u);
  EXPECT_EQ(result.counts.rank, 2);
  EXPECT_THAT(texts(result.states), ElementsAre("++++", "++--", "++00", "--++", "----", "--00",
                                                "00++", "00--", "0000"));
}

// A regular hexagon has irrational corners. Points p on the unit circle with normals -p have
// the stick planes (p_y, -p_x, -1): normals on a circular cone, no three in one plane. So any
// six distinct points give what the regular hexagon gives; here the nearest in Pythagorean
// triples of moderate size, (33, 56, 65), which keeps the hexagon's three antipodal pairs.
TEST(Counts, HexagonOfContacts) {
  const Rational c(33, 65);
  const Rational s(56, 65);
  const SlipStates result = enumerate_slip_states_cgal(
      stick_planes(test::inward_grasp({{1, 0}, {c, s}, {-c, s}, {-1, 0}, {-c, -s}, {c, -s}})));
  expect_counts(result, {30, 60, 32, 123});
}

// The mirrors of the reflection groups A3 and B3 cut the sphere in one triangle for each
// element: 24 and 48 faces, and 3/2 as many edges.
TEST(Counts, ReflectionGroups) {
  const std::vector<Vector3> a3 = {{1, 1, 0},  {1, -1, 0}, {1, 0, 1},
                                   {1, 0, -1}, {0, 1, 1},  {0, 1, -1}};
  expect_counts(enumerate_slip_states_cgal(a3), {14, 36, 24, 75});
  std::vector<Vector3> b3 = a3;
  b3.insert(b3.end(), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  expect_counts(enumerate_slip_states_cgal(b3), {26, 72, 48, 147});
}

}  // namespace
}  // namespace stickslip
