// SPDX-License-Identifier: GPL-3.0-or-later
// Facets, quality and slice of grasp wrench spaces, against enumeration of planes through three
// points.
#include "stickslip/earlier/grasp_wrench_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "paper_grasps.hpp"
#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/earlier/load_classes.hpp"

namespace stickslip {
namespace {

using test::RandomSource;
using Facets = std::map<IntegerVector<3>, Rational>;

Problem problem(const Grasp& grasp) {
  return Problem({grasp, {}}, NormalLaw::kUnilateral);
}

Rational height(const IntegerVector<3>& u, const Vector3& p) {
  return Rational(u[0]) * p[0] + Rational(u[1]) * p[1] + Rational(u[2]) * p[2];
}

/// 0 and the edge wrenches of each contact, torque divided by `length`.
std::vector<std::vector<Vector3>> triangles(const Grasp& grasp, const Rational& length) {
  std::vector<std::vector<Vector3>> result;
  for (const Contact& c : grasp.contacts()) {
    const Rational norm = *exact_sqrt(c.normal.x * c.normal.x + c.normal.y * c.normal.y);
    std::vector<Vector3> corners{{0, 0, 0}};
    for (const Rational& mu : {c.friction, Rational(-c.friction)}) {
      const Rational fx = (c.normal.x - mu * c.normal.y) / norm;
      const Rational fy = (c.normal.y + mu * c.normal.x) / norm;
      corners.push_back({fx, fy, (c.position.x * fy - c.position.y * fx) / length});
    }
    result.push_back(std::move(corners));
  }
  return result;
}

/// The points whose convex hull the space is.
std::vector<Vector3> spanning_points(const Grasp& grasp, ForceBound bound,
                                     const Rational& length) {
  std::vector<Vector3> points{{0, 0, 0}};
  for (const std::vector<Vector3>& corners : triangles(grasp, length)) {
    if (bound == ForceBound::kL1) {
      points.insert(points.end(), corners.begin() + 1, corners.end());
      continue;
    }
    std::vector<Vector3> sums;
    for (const Vector3& p : points) {
      for (const Vector3& q : corners) sums.push_back({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
    }
    std::sort(sums.begin(), sums.end());
    sums.erase(std::unique(sums.begin(), sums.end()), sums.end());
    points = std::move(sums);
  }
  return points;
}

/// Planes through three points with all others on one side. For a flat set these are the two
/// sides of one plane, or, if the points lie on a line, none.
Facets facets_by_triples(const std::vector<Vector3>& points) {
  Facets result;
  const auto minus = [](const Vector3& a, const Vector3& b) {
    return primitive_multiple<3>({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
  };
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (std::size_t c = 0; c < b; ++c) {
        const IntegerVector<3> u =
            primitive(cross(minus(points[b], points[a]), minus(points[c], points[a])));
        if (is_zero(u)) continue;
        for (const IntegerVector<3>& side : {u, negated(u)}) {
          const Rational top = height(side, points[a]);
          if (std::all_of(points.begin(), points.end(),
                          [&](const Vector3& p) { return height(side, p) <= top; })) {
            result[side] = top;
          }
        }
      }
    }
  }
  return result;
}

Facets as_map(const std::vector<HalfSpace>& facets) {
  Facets result;
  for (const HalfSpace& facet : facets) result[facet.normal] = facet.offset;
  EXPECT_EQ(result.size(), facets.size());
  return result;
}

Grasp unit_grasp(RandomSource& random, int round, int most) {
  const auto m = static_cast<std::size_t>(random.between(0, most));
  if (round % 2 == 0) return test::degenerate_grasp(random, m);
  const Grasp grasp = test::generic_grasp(random, m);
  return snap_normals(grasp, Rational(1, 100)).grasp;
}

void expect_same_facets(ForceBound bound, int rounds, int most_contacts, std::uint64_t seed) {
  RandomSource random(seed);
  int full = 0;
  int flat = 0;
  for (int round = 0; round < rounds; ++round) {
    const Grasp grasp = unit_grasp(random, round, most_contacts);
    const Rational length = random.pick<Rational>({1, 3, Rational(2, 5)});
    const std::vector<HalfSpace> found = wrench_space_facets(problem(grasp), bound, length);
    const Facets expected = facets_by_triples(spanning_points(grasp, bound, length));
    const GraspQuality quality = ferrari_canny_quality(found);
    if (expected.empty()) {  // a segment or a point: any plane that contains it
      ASSERT_EQ(found.size(), 2u);
      for (const Vector3& p : spanning_points(grasp, bound, length)) {
        EXPECT_EQ(height(found[0].normal, p), 0);
      }
      EXPECT_EQ(quality.radius_squared, 0);
      ++flat;
      continue;
    }
    EXPECT_EQ(as_map(found), expected) << test::describe({{grasp, {}}, {}});
    Rational least = -1;
    for (const auto& [u, h] : expected) {
      const Rational squared = h * h / Rational(dot(u, u));
      if (least < 0 || squared < least) least = squared;
    }
    EXPECT_EQ(quality.radius_squared, least);
    EXPECT_EQ(quality.nearest.offset * quality.nearest.offset,
              least * Rational(dot(quality.nearest.normal, quality.nearest.normal)));
    (expected.size() > 2 ? full : flat) += 1;
  }
  EXPECT_GE(full, rounds / 4);
  EXPECT_GE(flat, rounds / 20);
}

TEST(GraspWrenchSpace, L1FacetsByEnumeration) {
  expect_same_facets(ForceBound::kL1, 120, 6, 91);
}
TEST(GraspWrenchSpace, LinfFacetsByEnumeration) {
  expect_same_facets(ForceBound::kLinf, 60, 3, 92);
}

// By hand: 0, (1, +-1/2, -+1/2), (-+1/2, 1, -+1/2) and (-1, -+1/2, -+1/2) span it.
TEST(GraspWrenchSpace, QualityOfFig1) {
  for (const Grasp& grasp : {test::fig1_grasp(0), test::fig1_grasp(3)}) {
    const Problem p({grasp, {1, 2, 3}}, NormalLaw::kBilateral);
    const auto quality = [&](ForceBound bound) {
      return ferrari_canny_quality(wrench_space_facets(p, bound)).radius_squared;
    };
    EXPECT_EQ(quality(ForceBound::kL1), Rational(1, 9));
    EXPECT_EQ(quality(ForceBound::kLinf), Rational(1, 3));
  }
}

// Positive quality says that every load is weakly stable, and quality 0 that some is not.
TEST(GraspWrenchSpace, QualityIsForceClosure) {
  RandomSource random(93);
  int positive = 0;
  for (int round = 0; round < 200; ++round) {
    const Grasp grasp = unit_grasp(random, round, 5);
    for (const ForceBound bound : {ForceBound::kL1, ForceBound::kLinf}) {
      const auto quality = ferrari_canny_quality(wrench_space_facets(problem(grasp), bound));
      const IntegerVector<3>& u = quality.nearest.normal;
      // Pushing against the nearest facet: contacts must apply +u.
      const Wrench against{Rational(-u[0]), Rational(-u[1]), Rational(-u[2])};
      const LoadClass weak =
          weakly_stable_load(Problem({grasp, against}, NormalLaw::kUnilateral));
      EXPECT_EQ(std::holds_alternative<RigidForces>(weak), quality.radius_squared > 0);
      positive += quality.radius_squared > 0 ? 1 : 0;
    }
  }
  EXPECT_GE(positive, 40);
}

// Fig. 7(a). All edge wrenches have torque +-1/2, so the slice is spanned by the midpoints of
// one with torque 1/2 and one with -1/2.
TEST(ZeroTorqueSlice, OfFig1) {
  const std::vector<Vector2> expected{{-1, 0}, {0, Rational(-1, 2)},
                                      {1, 0},  {Rational(3, 4), Rational(3, 4)},
                                      {0, 1},  {Rational(-3, 4), Rational(3, 4)}};
  EXPECT_EQ(zero_torque_slice(problem(test::fig1_grasp(0))), expected);
}

// Each vertex is in the space and on two facets of different slopes; each facet that meets the
// plane holds all vertices; the polygon turns left.
TEST(ZeroTorqueSlice, AgreesWithTheFacets) {
  RandomSource random(94);
  int polygons = 0;
  for (int round = 0; round < 150; ++round) {
    const Grasp grasp = unit_grasp(random, round, 6);
    const std::vector<HalfSpace> facets = wrench_space_facets(problem(grasp), ForceBound::kL1);
    const std::vector<Vector2> slice = zero_torque_slice(problem(grasp));
    ASSERT_FALSE(slice.empty());
    for (std::size_t k = 0; k < slice.size(); ++k) {
      std::size_t tight = 0;
      std::vector<IntegerVector<3>> tight_slopes;
      for (const HalfSpace& f : facets) {
        const Rational gap = f.offset - height(f.normal, {slice[k].x, slice[k].y, 0});
        EXPECT_GE(gap, 0);
        if (gap == 0) tight_slopes.push_back({f.normal[0], f.normal[1], 0});
      }
      for (const auto& slope : tight_slopes) {
        for (const auto& other : tight_slopes) tight += is_zero(cross(slope, other)) ? 0 : 1;
      }
      if (facets.size() > 2) {
        EXPECT_GE(tight, 1u);
      }
      if (slice.size() < 3) continue;
      const Vector2& a = slice[k];
      const Vector2& b = slice[(k + 1) % slice.size()];
      const Vector2& c = slice[(k + 2) % slice.size()];
      EXPECT_GT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0);
      // Completeness: the edge lies on the border of the space.
      const Vector3 middle{(a.x + b.x) / 2, (a.y + b.y) / 2, 0};
      EXPECT_TRUE(std::any_of(facets.begin(), facets.end(), [&](const HalfSpace& f) {
        return height(f.normal, middle) == f.offset;
      }));
    }
    polygons += slice.size() > 2 ? 1 : 0;
  }
  EXPECT_GE(polygons, 40);
}

TEST(GraspWrenchSpace, WithoutContacts) {
  for (const ForceBound bound : {ForceBound::kL1, ForceBound::kLinf}) {
    const auto facets = wrench_space_facets(problem(Grasp()), bound);
    EXPECT_EQ(facets.size(), 2u);
    EXPECT_EQ(ferrari_canny_quality(facets).radius_squared, 0);
  }
  EXPECT_EQ(zero_torque_slice(problem(Grasp())), (std::vector<Vector2>{{0, 0}}));
}

// A square gripped as in Fig. 4: half as long a unit makes torques count twice.
TEST(GraspWrenchSpace, LengthScalesTorques) {
  const Problem p = problem(test::fig4_grasp(0));
  const auto whole = wrench_space_facets(p, ForceBound::kL1, 1);
  const auto half = wrench_space_facets(p, ForceBound::kL1, Rational(1, 2));
  ASSERT_EQ(whole.size(), half.size());
  EXPECT_LT(ferrari_canny_quality(whole).radius_squared, 1);
  EXPECT_GE(ferrari_canny_quality(half).radius_squared,
            ferrari_canny_quality(whole).radius_squared);
  EXPECT_THROW(wrench_space_facets(p, ForceBound::kL1, 0), ContractError);
}

TEST(GraspWrenchSpace, NeedsRationalLengths) {
  const Problem p = problem(Grasp({{{0, 0}, {1, 0}, 1, 1, 0}, {{0, 0}, {1, 1}, 1, 1, 0}}));
  for (const ForceBound bound : {ForceBound::kL1, ForceBound::kLinf}) {
    try {
      wrench_space_facets(p, bound);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), "contacts[1].normal");
      EXPECT_NE(error.remedy().find("stickslip snap GRASP -o FILE"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace stickslip
