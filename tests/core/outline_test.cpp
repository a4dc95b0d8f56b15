// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_numbers.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/snap.hpp"

namespace stickslip {
namespace {

using testing::Random;

Rational dot(const Vector2& a, const Vector2& b) {
  return a.x * b.x + a.y * b.y;
}
Vector2 operator-(const Vector2& a, const Vector2& b) {
  return {a.x - b.x, a.y - b.y};
}

/// Around the origin, which every edge sees from one side.
Ring star(Random& random, int vertices) {
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    // Rational points of the unit circle, in order, and further out.
    const Rational t(2 * i + 1 - vertices, 2);
    const Rational radius(random.integer(1, 50), random.integer(1, 7));
    ring.push_back({radius * (1 - t * t) / (1 + t * t), radius * 2 * t / (1 + t * t)});
  }
  return ring;
}

TEST(Outline, NormalsPointIntoTheBodyWhateverTheSenseOfTheRing) {
  Random random(7);
  for (int round = 0; round < 200; ++round) {
    const int vertices = random.integer(4, 12);
    Ring ring = star(random, vertices);
    Ring hole = ring;
    for (Vector2& v : hole) v = {v.x / 100, v.y / 100};
    if (round % 2 == 0) std::reverse(ring.begin(), ring.end());
    if (round % 3 == 0) std::reverse(hole.begin(), hole.end());
    const auto edges = outline_edges({{ring, hole}})[0];
    ASSERT_EQ(edges.size(), 2 * ring.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const OutlineEdge& edge = edges[i];
      const Ring& of = i < ring.size() ? ring : hole;
      EXPECT_EQ(edge.from, of[i % ring.size()]);
      EXPECT_EQ(edge.to, of[(i + 1) % ring.size()]);
      EXPECT_EQ(dot(edge.inwards, edge.to - edge.from), 0);
      // A star of less than half a turn a step has the origin on its inner side.
      const int inner = dot(edge.inwards, Vector2{} - edge.from).sign();
      EXPECT_EQ(inner, i < ring.size() ? 1 : -1) << "edge " << i << " of " << round;
    }
  }
}

TEST(Outline, NormalsHaveLengthOneWhereTheyCan) {
  const auto edges = outline_edges({{{{0, 0}, {3, 4}, {0, 4}}}, {{{0, 0}, {1, 1}, {0, 7}}}});
  EXPECT_EQ(edges[0][0].inwards, (Vector2{Rational(-4, 5), Rational(3, 5)}));
  EXPECT_EQ(edges[0][1].inwards, (Vector2{0, -1}));
  EXPECT_EQ(edges[0][2].inwards, (Vector2{1, 0}));
  EXPECT_EQ(edges[1][0].inwards, (Vector2{-1, 1}));
}

TEST(Outline, PlacesOnAnEdge) {
  const OutlineEdge edge{{1, 2}, {4, -4}, {}};
  EXPECT_EQ(edge.at(0), edge.from);
  EXPECT_EQ(edge.at(1), edge.to);
  EXPECT_EQ(edge.at(Rational(1, 3)), (Vector2{2, 0}));
}

TEST(Outline, IsCheckedByGrasp) {
  EXPECT_NO_THROW(Grasp({}, GraspDescription{"", {{{{0, 0}, {1, 0}, {0, 1}}}}}));
  EXPECT_THROW(Grasp({}, GraspDescription{"", {{{{0, 0}, {1, 0}, {2, 0}}}}}), InputError);
  EXPECT_THROW(Grasp({}, GraspDescription{"", {{}}}), InputError);
}

TEST(Outline, StaysWithTheGrasp) {
  const std::vector<Polygon> outline{{{{0, 0}, {1, 0}, {0, 1}}}};
  const Grasp grasp({{{0, 0}, {1, 1}, 0, 1, 0}}, GraspDescription{"corner", outline});
  EXPECT_EQ(grasp.with_preload(1).description().outline, outline);
  EXPECT_EQ(snap_normals(grasp, Rational(1, 10)).grasp.description().outline, outline);
  EXPECT_EQ(grasp.name(), "corner");
}

}  // namespace
}  // namespace stickslip
