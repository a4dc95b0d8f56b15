// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "random_numbers.hpp"
#include "rounds.hpp"
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

/// What is wrong with a polygon, and where.
std::string fault(const Polygon& polygon) {
  try {
    check_outline({polygon});
  } catch (const InputError& error) {
    return error.place() + ": " + error.problem();
  }
  return "";
}

const Ring kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

Ring moved(Ring ring, const Rational& factor, const Vector2& by) {
  for (Vector2& v : ring) v = {factor * v.x + by.x, factor * v.y + by.y};
  return ring;
}

TEST(Outline, RingsDoNotMeetThemselves) {
  EXPECT_EQ(fault({{{0, 0}, {4, 0}, {0, 3}, {5, 4}}}), "outline[0]: its edges 1 and 3 meet");
  EXPECT_EQ(fault({{{0, 0}, {4, 0}, {0, 3}, {4, 4}}}),
            "outline[0][0]: the ring has no area");  // its halves cancel
  // A vertex on an edge; a vertex twice; an edge twice; a spike; half a spike; a square that
  // goes back along an edge.
  EXPECT_EQ(fault({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}),
            "outline[0]: its edges 0 and 3 meet");
  EXPECT_EQ(fault({{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}),
            "outline[0]: its edges 1 and 4 meet");
  EXPECT_EQ(fault({{{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}}}),
            "outline[0]: its edges 0 and 2 meet");
  EXPECT_EQ(fault({{{0, 0}, {6, 0}, {4, 0}, {4, 4}}}), "outline[0]: its edges 0 and 1 meet");
  EXPECT_EQ(fault({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 6}}}),
            "outline[0]: its edges 2 and 4 meet");
  // Straight on is no fault, nor is what nearly meets.
  EXPECT_EQ(fault({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}}}), "");
  EXPECT_EQ(fault({{{0, 0}, {4, 0}, {4, 4}, {2, parse_rational("1e-30")}, {0, 4}}}), "");
}

TEST(Outline, HolesAreInsideAndApart) {
  const Ring hole = moved(kSquare, Rational(1, 4), {1, 1});
  EXPECT_EQ(fault({kSquare, hole}), "");
  EXPECT_EQ(fault({kSquare, moved(kSquare, 1, {10, 0})}),
            "outline[0][1]: the hole is not inside the outer ring");
  EXPECT_EQ(fault({hole, kSquare}), "outline[0][1]: the hole is not inside the outer ring");
  EXPECT_EQ(
      fault({kSquare, hole, moved(kSquare, Rational(1, 8), {Rational(5, 4), Rational(5, 4)})}),
      "outline[0][2]: the hole is inside another one, ring 1");
  EXPECT_EQ(
      fault({kSquare, moved(kSquare, Rational(1, 8), {Rational(5, 4), Rational(5, 4)}), hole}),
      "outline[0][1]: the hole is inside another one, ring 2");
  EXPECT_EQ(fault({kSquare, hole, moved(hole, 1, {Rational(3, 2), 0})}), "");
  EXPECT_EQ(fault({kSquare, hole, moved(hole, 1, {1, 0})}),
            "outline[0]: its edges 4 and 8 meet");
  EXPECT_EQ(fault({kSquare, moved(hole, 1, {-1, 0})}), "outline[0]: its edges 3 and 4 meet");
  EXPECT_EQ(fault({kSquare, kSquare}), "outline[0]: its edges 0 and 4 meet");
}

/// Whether p is on the segment from a to b.
bool is_on(const Vector2& p, const Vector2& a, const Vector2& b) {
  const Vector2 along = b - a;
  const Vector2 to_p = p - a;
  if (along.x * to_p.y != along.y * to_p.x) return false;
  const Rational share = dot(to_p, along) / dot(along, along);
  return share >= 0 && share <= 1;
}

/// Whether the segments have a common point besides `allowed`: by Cramer's rule.
bool share_more_than(const Vector2* allowed, const Vector2& a, const Vector2& b,
                     const Vector2& c, const Vector2& d) {
  const Vector2 u = b - a;
  const Vector2 v = d - c;
  const Rational det = u.x * v.y - u.y * v.x;
  if (det.is_zero()) {
    const auto other = [&](const Vector2& p) { return allowed == nullptr || !(p == *allowed); };
    return (other(a) && is_on(a, c, d)) || (other(b) && is_on(b, c, d)) ||
           (other(c) && is_on(c, a, b)) || (other(d) && is_on(d, a, b));
  }
  const Vector2 w = c - a;
  const Rational s = (w.x * v.y - w.y * v.x) / det;
  const Rational t = (w.x * u.y - w.y * u.x) / det;
  return allowed == nullptr && s >= 0 && s <= 1 && t >= 0 && t <= 1;
}

TEST(Outline, SmallWorldOfRings) {
  Random random(11);
  int simple = 0;
  for (int round = 0; round < 20000; ++round) {
    Ring ring;
    for (int n = random.integer(3, 6); n > 0; --n) {
      ring.push_back({random.integer(0, 3), random.integer(0, 3)});
    }
    const std::string said = fault({ring});
    if (said.find("the same as") != std::string::npos ||
        said.find("no area") != std::string::npos) {
      continue;
    }
    const std::size_t n = ring.size();
    bool meets = false;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        const Vector2* joint = j == i + 1 ? &ring[j] : (j + 1) % n == i ? &ring[i] : nullptr;
        meets =
            meets || share_more_than(joint, ring[i], ring[i + 1], ring[j], ring[(j + 1) % n]);
      }
    }
    EXPECT_EQ(said.find(" meet") != std::string::npos, meets) << said;
    simple += meets ? 0 : 1;
  }
  EXPECT_GT(simple, 1000);
}

TEST(Outline, ManyVertices) {
  Ring comb;  // edges that overlap in x, and in y with few
  constexpr int kTeeth = test::kSanitized ? 250 : 2500;
  for (int i = 0; i < kTeeth; ++i) {
    comb.push_back({0, 2 * i});
    comb.push_back({100, 2 * i});
    comb.push_back({100, 2 * i + 1});
    comb.push_back({1, 2 * i + 1});
  }
  comb.push_back({1, 2 * kTeeth});
  comb.push_back({-1, 2 * kTeeth});
  comb.push_back({-1, 0});
  EXPECT_EQ(fault({comb}), "");
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
