// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/plane_cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "plane_oracle.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::generates;
using test::Generators;
using test::probes;
using test::small_world;

PlaneCell hull(Generators generators) {
  return PlaneCell::hull(std::move(generators));
}

TEST(PlaneCell, CanonicalForms) {
  const PlaneCell triangle = hull({{1, 0, 1}, {0, 0, 1}, {1, 1, 3}, {0, 1, 1}, {2, 0, 4}});
  EXPECT_EQ(triangle.vertices(), (std::vector<PlanePoint>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(triangle.dimension(), 2);
  EXPECT_EQ(triangle.edges().size(), 3u);

  const PlaneCell wedge = hull({{1, 1, 1}, {0, 0, 1}, {0, 2, 0}, {1, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(wedge.vertices(), (std::vector<PlanePoint>{{0, 0}}));
  EXPECT_EQ(wedge.rays(), (std::vector<PlaneDirection>{{1, 0}, {0, 1}}));
  ASSERT_EQ(wedge.edges().size(), 2u);
  EXPECT_EQ(wedge.edges()[0].from, (HomogeneousPoint{0, 1, 0}));  // comes down the y axis

  const PlaneCell half_strip = hull({{0, 0, 1}, {0, 1, 1}, {1, 0, 0}});
  EXPECT_EQ(half_strip.vertices(), (std::vector<PlanePoint>{{0, 1}, {0, 0}}));
  EXPECT_EQ(half_strip.edges().size(), 3u);

  const PlaneCell strip = hull({{0, 0, 1}, {0, 1, 1}, {-2, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(strip.vertices(), (std::vector<PlanePoint>{{0, 0}, {0, 1}}));
  EXPECT_EQ(strip.rays(), (std::vector<PlaneDirection>{{1, 0}, {-1, 0}}));
  EXPECT_EQ(strip.dimension(), 2);

  const PlaneCell line = hull({{2, 0, 1}, {1, -1, 0}, {-1, 1, 0}});
  EXPECT_EQ(line.vertices(), (std::vector<PlanePoint>{{1, 1}}));
  EXPECT_EQ(line.dimension(), 1);

  const PlaneCell half_plane = hull({{5, 2, 1}, {1, 0, 0}, {-1, 0, 0}, {7, -1, 0}});
  EXPECT_EQ(half_plane.vertices(), (std::vector<PlanePoint>{{0, 2}}));
  EXPECT_EQ(half_plane.rays(), (std::vector<PlaneDirection>{{-1, 0}, {1, 0}, {0, -1}}));

  const PlaneCell plane = hull({{5, 2, 1}, {1, 0, 0}, {-1, 1, 0}, {0, -1, 0}});
  EXPECT_EQ(plane.vertices(), (std::vector<PlanePoint>{{0, 0}}));
  EXPECT_TRUE(plane.edges().empty());
  EXPECT_TRUE(plane.contains({100, -100}));

  EXPECT_EQ(hull({{3, 6, 3}, {1, 2, 1}}).vertices(), (std::vector<PlanePoint>{{1, 2}}));
  EXPECT_EQ(hull({{0, 0, 1}, {1, 1, 1}, {2, 2, 1}}).vertices(),
            (std::vector<PlanePoint>{{0, 0}, {2, 2}}));
}

TEST(PlaneCell, NeedsAPoint) {
  EXPECT_THROW(hull({}), ContractError);
  EXPECT_THROW(hull({{1, 0, 0}}), ContractError);
  EXPECT_THROW(hull({{0, 0, 1}, {0, 0, 0}}), ContractError);
  EXPECT_THROW(hull({{0, 0, -1}}), ContractError);
}

/// Every set of at most two points and three directions, and of three points and two:
/// contains() on the probes, by a linear program over the generators as given.
TEST(PlaneCell, SmallWorld) {
  std::vector<Generators> sets;
  const auto bit_set = [](unsigned bits, int h) {
    Generators result;
    for (int i = 0, x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        if (h == 0 && x == 0 && y == 0) continue;
        if ((bits >> i++ & 1u) != 0) result.push_back({x, y, h});
      }
    }
    return result;
  };
  for (unsigned points = 1; points < 512; ++points) {
    const Generators p = bit_set(points, 1);
    for (unsigned rays = 0; rays < 256 && p.size() <= 3; ++rays) {
      Generators g = bit_set(rays, 0);
      if (g.size() > (p.size() == 3 ? 1 : p.size() == 2 ? 2 : 3)) continue;
      g.insert(g.begin(), p.begin(), p.end());
      sets.push_back(std::move(g));
    }
  }
  EXPECT_GT(sets.size(), 2000u);
  for (const Generators& set : sets) {
    const PlaneCell cell = hull(set);
    Generators reversed(set.rbegin(), set.rend());
    ASSERT_EQ(cell, hull(reversed));
    ASSERT_EQ(cell, hull(cell.generators()));
    for (const PlanePoint& p : probes()) {
      ASSERT_EQ(cell.contains(p), generates(set, p))
          << test::describe({cell}) << p[0] << ", " << p[1];
    }
    for (const PlaneEdge& edge : cell.edges()) {
      for (const HomogeneousPoint& g : set) {
        ASSERT_GE(determinant(edge.from, edge.to, g).sign(), 0) << test::describe({cell});
      }
    }
  }
}

TEST(PlaneCell, ClipIsIntersection) {
  const std::vector<HomogeneousPoint> half_planes{
      {1, 0, 0}, {-1, 0, 0}, {0, -2, 1}, {1, 1, -1}, {-1, 2, 1}, {0, 0, 1}, {0, 0, -1}};
  for (const PlaneCell& cell : small_world(2, 2)) {
    for (const HomogeneousPoint& f : half_planes) {
      const std::optional<PlaneCell> part = clip(cell, f);
      for (const PlanePoint& p : probes()) {
        const bool kept = cell.contains(p) &&
                          Rational(f[0]) * p[0] + Rational(f[1]) * p[1] + Rational(f[2]) >= 0;
        ASSERT_EQ(part && part->contains(p), kept) << test::describe({cell});
      }
    }
    const std::optional<PlaneCell> boxed = clip_to_box(cell, {-1, Rational(-1, 2)}, {2, 1});
    ASSERT_TRUE(!boxed || boxed->is_bounded());
    for (const PlanePoint& p : probes()) {
      ASSERT_EQ(boxed && boxed->contains(p), cell.contains(p) && p[0] >= -1 && p[0] <= 2 &&
                                                 p[1] >= Rational(-1, 2) && p[1] <= 1);
    }
  }
}

}  // namespace
}  // namespace stickslip
