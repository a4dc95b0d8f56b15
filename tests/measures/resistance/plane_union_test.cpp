// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/plane_union.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "plane_oracle.hpp"

namespace stickslip {
namespace {

using test::expect_union;
using test::Generators;
using test::small_world;

PlaneCell hull(Generators generators) {
  return PlaneCell::hull(std::move(generators));
}

PlaneCell box(int low_x, int low_y, int high_x, int high_y) {
  return hull({{low_x, low_y, 1}, {high_x, low_y, 1}, {high_x, high_y, 1}, {low_x, high_y, 1}});
}

PlaneCell segment(int x, int y, int to_x, int to_y) {
  return hull({{x, y, 1}, {to_x, to_y, 1}});
}

PlaneUnion checked(const std::vector<PlaneCell>& cells) {
  PlaneUnion result = unite(cells);
  expect_union(cells, result);
  return result;
}

using Points = std::vector<PlanePoint>;

// With assertions, which take long, a part of what is done without.
#if defined(STICKSLIP_FEWER_UNIONS) || !defined(NDEBUG)
constexpr std::size_t kShare = 8;
constexpr int kRounds = 100;
#else
constexpr std::size_t kShare = 1;
constexpr int kRounds = 1000;
#endif

TEST(PlaneUnion, Nothing) {
  EXPECT_TRUE(checked({}).is_empty());
}

TEST(PlaneUnion, IslandInAHole) {
  const PlaneUnion u = checked(
      {box(0, 0, 5, 1), box(0, 4, 5, 5), box(0, 0, 1, 5), box(4, 0, 5, 5), box(2, 2, 3, 3)});
  ASSERT_EQ(u.areas.size(), 2u);
  EXPECT_TRUE(u.contains({Rational(5, 2), Rational(5, 2)}));
  EXPECT_FALSE(u.contains({Rational(3, 2), Rational(3, 2)}));
}

TEST(PlaneUnion, AnAreaMayTouchItself) {
  // A ring whose hole touches the outside at (0, 0).
  const PlaneUnion u = checked({hull({{0, 0, 1}, {3, 0, 1}, {2, 1, 1}}),
                                hull({{3, 0, 1}, {3, 3, 1}, {2, 1, 1}, {2, 2, 1}}),
                                hull({{3, 3, 1}, {0, 3, 1}, {2, 2, 1}, {1, 2, 1}}),
                                hull({{0, 3, 1}, {0, 0, 1}, {1, 2, 1}})});
  ASSERT_EQ(u.areas.size(), 1u);
  ASSERT_EQ(u.areas[0].outlines.size(), 1u);
  const Points& v = u.areas[0].outlines[0].vertices;
  EXPECT_EQ(std::count(v.begin(), v.end(), (PlanePoint{0, 0})), 2);
}

TEST(PlaneUnion, ThinPartsStayOutsideOfAreasOnly) {
  // Through a box, along its border, crossing another, and collinear ones that overlap.
  const PlaneUnion u = checked({box(0, 0, 2, 2), segment(-1, 1, 3, 1), segment(0, 0, 4, 0),
                                segment(3, -1, 3, 3), segment(5, 0, 7, 0), segment(6, 0, 8, 0),
                                hull({{9, 9, 1}}), hull({{1, 2, 1}}), hull({{3, 2, 1}})});
  ASSERT_EQ(u.areas.size(), 1u);
  EXPECT_EQ(u.curves, (std::vector<PlaneCell>{segment(-1, 1, 0, 1), segment(2, 0, 4, 0),
                                              segment(2, 1, 3, 1), segment(3, -1, 3, 3),
                                              segment(5, 0, 8, 0)}));
  EXPECT_EQ(u.points, (Points{{9, 9}}));
}

TEST(PlaneUnion, LinesAndRays) {
  const PlaneCell right = hull({{0, 1, 1}, {1, 0, 0}});
  const PlaneCell left = hull({{2, 1, 1}, {-1, 0, 0}});
  const PlaneUnion u = checked({right, left, hull({{5, 5, 1}, {1, 1, 0}})});
  EXPECT_EQ(u.curves, (std::vector<PlaneCell>{hull({{7, 1, 1}, {1, 0, 0}, {-1, 0, 0}}),
                                              hull({{5, 5, 1}, {1, 1, 0}})}));
}

TEST(PlaneUnion, HalfPlanes) {
  const PlaneCell up = hull({{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}});
  const PlaneCell down = hull({{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, -1, 0}});
  const PlaneCell lower = hull({{0, -1, 1}, {1, 0, 0}, {-1, 0, 0}, {0, -1, 0}});
  EXPECT_TRUE(checked({up, down}).is_whole_plane());
  EXPECT_TRUE(checked({hull({{1, 2, 1}, {1, 0, 0}, {-1, 1, 0}, {0, -1, 0}})}).is_whole_plane());
  const PlaneUnion gap = checked({up, lower, hull({{1, -1, 2}})});
  EXPECT_EQ(gap.areas.size(), 2u);
  EXPECT_EQ(gap.points.size(), 1u);
  const Outline border = checked({down}).areas.at(0).outlines.at(0);
  EXPECT_EQ(border.from, (PlaneDirection{1, 0}));
  EXPECT_EQ(border.vertices, (Points{{0, 0}}));
  EXPECT_EQ(border.to, (PlaneDirection{-1, 0}));
}

TEST(PlaneUnion, UnboundedWithAHole) {
  const std::vector<PlaneCell> cells{hull({{0, 1, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}),
                                     hull({{0, -1, 1}, {1, 0, 0}, {-1, 0, 0}, {0, -1, 0}}),
                                     hull({{1, 0, 1}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}}),
                                     hull({{-1, 0, 1}, {0, 1, 0}, {0, -1, 0}, {-1, 0, 0}})};
  const PlaneUnion u = checked(cells);
  ASSERT_EQ(u.areas.size(), 1u);
  ASSERT_EQ(u.areas[0].outlines.size(), 1u);
  EXPECT_EQ(u.areas[0].outlines[0].vertices, (Points{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}));
  EXPECT_TRUE(u.contains({1000000, 999999}));
}

/// Of all pairs of cells with few generators in {-1, 0, 1}, those whose first is the least of
/// its images under the symmetries of the square.
TEST(PlaneUnion, SmallWorldOfPairs) {
  const std::vector<PlaneCell> cells = small_world(2, 1);
  const auto is_least = [](const PlaneCell& cell) {
    for (const bool swap : {false, true}) {
      for (const int sx : {-1, 1}) {
        for (const int sy : {-1, 1}) {
          Generators images = cell.generators();
          for (HomogeneousPoint& g : images) {
            g = {sx * g[swap ? 1 : 0], sy * g[swap ? 0 : 1], g[2]};
          }
          if (PlaneCell::hull(images) < cell) return false;
        }
      }
    }
    return true;
  };
  std::size_t pairs = 0;
  for (const PlaneCell& first : cells) {
    if (!is_least(first)) continue;
    for (const PlaneCell& second : cells) {
      if (::testing::Test::HasFailure()) return;
      if (++pairs % kShare == 0) checked({first, second});
    }
  }
  EXPECT_GT(pairs, 10000u);
}

/// Several cells: the naive twin; and the same union from the cells in another order, twice, or
/// each cut in two.
TEST(PlaneUnion, RandomCells) {
  const std::vector<PlaneCell> world = small_world(3, 2);
  std::mt19937_64 random(7);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<PlaneCell> cells;
    const std::size_t count = 3 + random() % 6;
    while (cells.size() < count) {
      const PlaneCell& cell = world[random() % world.size()];
      if (!cell.is_bounded() && random() % 4 != 0) continue;
      // Somewhere else, at another scale.
      Generators moved = cell.generators();
      const Integer scale = 1 + static_cast<int>(random() % 3);
      const int x = static_cast<int>(random() % 5) - 2;
      const int y = static_cast<int>(random() % 5) - 2;
      for (HomogeneousPoint& g : moved) g = {g[0] + x * g[2], g[1] + y * g[2], g[2] * scale};
      cells.push_back(PlaneCell::hull(std::move(moved)));
    }
    const PlaneUnion u = checked(cells);
    std::vector<PlaneCell> again = cells;
    again.insert(again.end(), cells.begin(), cells.end());
    std::shuffle(again.begin(), again.end(), random);
    ASSERT_EQ(unite(again), u) << test::describe(cells);
    std::vector<PlaneCell> parts;
    for (const PlaneCell& cell : cells) {
      const int a = static_cast<int>(random() % 7) - 3;
      const int b = static_cast<int>(random() % 7) - 3;
      const HomogeneousPoint f{a, b, 1};
      for (const HomogeneousPoint& side : {f, negated(f)}) {
        if (const auto part = clip(cell, side)) parts.push_back(*part);
      }
    }
    ASSERT_EQ(unite(parts), u) << test::describe(cells) << test::describe(unite(parts));
    if (::testing::Test::HasFailure()) return;
  }
}

/// Coordinates far beyond the range of doubles, where CGAL's filtered kernel lost intersections
/// (found by near-degenerate grasps, whose frame had 10^160): an affine image of small cells.
TEST(PlaneUnion, HugeAndTinyNumbers) {
  const Rational huge(pow(Integer(10), 200));
  const auto image = [&](const PlanePoint& p) -> PlanePoint {
    return {huge * p[0] + p[1] / 3, p[1] / huge - p[0]};
  };
  const std::vector<PlaneCell> world = small_world(3, 2);
  std::mt19937_64 random(9);
  for (int round = 0; round < 50; ++round) {
    std::vector<PlaneCell> cells;
    std::vector<PlaneCell> images;
    while (cells.size() < 4) {
      const PlaneCell& cell = world[random() % world.size()];
      if (cell.is_bounded() == (cells.size() % 2 == 0)) continue;
      cells.push_back(cell);
      Generators moved;
      for (const PlanePoint& p : cell.vertices()) moved.push_back(homogeneous(image(p)));
      for (const PlaneDirection& d : cell.rays()) {
        const PlanePoint tip = image({Rational(d[0]), Rational(d[1])});
        moved.push_back(homogeneous(primitive_multiple(tip)));
      }
      images.push_back(PlaneCell::hull(std::move(moved)));
    }
    const PlaneUnion plain = checked(cells);
    const PlaneUnion far = unite(images);
    ASSERT_EQ(far.areas.size(), plain.areas.size()) << test::describe(cells);
    ASSERT_EQ(far.curves.size(), plain.curves.size()) << test::describe(cells);
    for (const PlanePoint& p : test::probes()) {
      ASSERT_EQ(far.contains(image(p)), plain.contains(p)) << test::describe(cells);
    }
  }
}

}  // namespace
}  // namespace stickslip
