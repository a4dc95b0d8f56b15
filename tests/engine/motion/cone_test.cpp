// SPDX-License-Identifier: GPL-3.0-or-later
// The double description of a cone against brute force over all sets of planes.
#include "stickslip/engine/cone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/motion/tree_walk.hpp"
#include "naive_region.hpp"
#include "random_grasps.hpp"
#include "stickslip/engine/strict_cone.hpp"

namespace stickslip {
namespace {

using test::Constraint;
using test::Generators;
using test::RandomSource;
using test::Rays;
using test::to_rational;
using test::value_at;

struct Cut {
  IntegerVector5 plane;
  Side side;
};

using Multiples = Cone::Multiples;

Cone cone_of(const std::vector<Cut>& cuts, Multiples multiples = Multiples::kZero) {
  Cone cone(multiples);
  for (const Cut& cut : cuts) cone.cut(cut.plane, cut.side);
  return cone;
}

/// l = 0 comes last: cones do not count it.
std::vector<Constraint> constraints_of(const std::vector<Cut>& cuts,
                                       Multiples multiples = Multiples::kZero) {
  std::vector<Constraint> result = {{{0, 0, 0, 1}, 1}};
  for (const Cut& cut : cuts) {
    const int sign = cut.side == Side::kPositive ? 1 : cut.side == Side::kZero ? 0 : -1;
    result.push_back({to_rational(cut.plane), sign});
  }
  if (multiples == Multiples::kZero) result.push_back({{0, 0, 0, 0, 1}, 0});
  return result;
}

/// The values of all constraints at x, scaled: the same for x and x' iff they differ by a
/// positive factor and a line.
std::vector<Rational> profile(const std::vector<Constraint>& constraints, const Vector5& x) {
  std::vector<Rational> values;
  Rational largest = 0;
  for (const Constraint& c : constraints) {
    values.push_back(value_at(c.function, x));
    largest = std::max(largest, Rational(abs(values.back())));
  }
  if (!largest.is_zero()) {
    for (Rational& entry : values) entry /= largest;
  }
  return values;
}

std::string text(const std::vector<Cut>& cuts) {
  std::string result;
  for (const Cut& cut : cuts) {
    for (const Integer& entry : cut.plane) result += entry.str() + " ";
    result += cut.side == Side::kPositive ? ">= 0\n"
              : cut.side == Side::kZero   ? "= 0\n"
                                          : "<= 0\n";
  }
  return result;
}

/// Everything that Cone promises, against brute force.
void expect_right(const std::vector<Cut>& cuts, Multiples multiples) {
  SCOPED_TRACE(text(cuts));
  const Cone cone = cone_of(cuts, multiples);
  const std::vector<Constraint> constraints = constraints_of(cuts, multiples);
  const Generators expected = test::brute_force_generators(constraints);
  ASSERT_EQ(cone.constraint_count(), 1 + cuts.size());

  Rays lines;
  for (const IntegerVector5& line : cone.lines()) {
    lines.push_back(to_rational(line));
    EXPECT_EQ(primitive(line), line);
    for (const Constraint& c : constraints) {
      EXPECT_TRUE(value_at(c.function, lines.back()).is_zero());
    }
  }
  EXPECT_EQ(lines.size(), expected.lines.size());
  EXPECT_EQ(test::rank_of(lines), lines.size());

  std::set<std::vector<Rational>> wanted;
  for (const Vector5& ray : expected.rays) wanted.insert(profile(constraints, ray));
  std::set<std::vector<Rational>> found;
  for (const Ray& ray : cone.rays()) {
    const Vector5 x = to_rational(ray.x);
    EXPECT_EQ(primitive(ray.x), ray.x);
    EXPECT_TRUE(found.insert(profile(constraints, x)).second) << "a ray twice";
    std::vector<ConstraintIndex> tight;
    for (std::size_t c = 0; c < constraints.size(); ++c) {
      EXPECT_TRUE(constraints[c].holds_at(x));
      if (c < cone.constraint_count() && value_at(constraints[c].function, x).is_zero()) {
        tight.push_back(static_cast<ConstraintIndex>(c));
      }
    }
    EXPECT_EQ(ray.tight, tight);
  }
  EXPECT_EQ(found, wanted);
  EXPECT_EQ(cone.directions().size(), 2 * cone.lines().size() + cone.rays().size());
}

void expect_right(const std::vector<Cut>& cuts) {
  expect_right(cuts, Multiples::kZero);
  expect_right(cuts, Multiples::kAny);
}

/// After every cut, so that the first wrong one is named.
void expect_right_throughout(const std::vector<Cut>& cuts) {
  for (std::size_t n = 0; n <= cuts.size() && !::testing::Test::HasFailure(); ++n) {
    expect_right({cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(n)});
  }
}

Side random_side(RandomSource& random) {
  const int die = random.between(1, 5);
  return die <= 2 ? Side::kPositive : die <= 4 ? Side::kNegative : Side::kZero;
}

IntegerVector5 random_plane(RandomSource& random, int bound) {
  IntegerVector5 plane;
  for (Integer& entry : plane) entry = random.between(-bound, bound);
  return plane;
}

TEST(Cone, CanBecomeEmpty) {
  // Down to the ray (0, 0, 0, 1), then to the origin.
  const std::vector<Cut> cuts = {{{1, 0, 0, 0}, Side::kZero},
                                 {{0, 1, 0, 0}, Side::kZero},
                                 {{0, 0, 1, 0}, Side::kZero},
                                 {{0, 0, 0, 1}, Side::kNegative},
                                 {{1, 1, 1, 1}, Side::kPositive}};
  expect_right_throughout(cuts);
  const Cone cone = cone_of(cuts);
  EXPECT_TRUE(cone.rays().empty());
  EXPECT_TRUE(cone.directions().empty());
  const SignRange range = ConeSigns(cone).on({1, 2, 3, 4});
  EXPECT_TRUE(range.is_zero() && range.is_nonnegative() && range.is_nonpositive());
}

TEST(Cone, ZeroPlaneChangesNothingButCounts) {
  for (const Side side : {Side::kPositive, Side::kZero, Side::kNegative}) {
    expect_right_throughout({{{1, 0, 0, 1}, Side::kPositive},
                             {{0, 0, 0, 0}, side},
                             {{0, 1, 0, -1}, Side::kNegative},
                             {{0, 0, 1, 0}, Side::kPositive},
                             {{0, 0, 0, 0}, side}});
  }
}

TEST(Cone, ManyPlanesThroughOneRay) {
  // All touch the ray (1, 1, 1, 1): a cone over a polygon, with the ray as its apex.
  RandomSource random(7);
  for (int round = 0; round < 20; ++round) {
    std::vector<Cut> cuts;
    for (int n = 0; n < 8; ++n) {
      IntegerVector5 plane = random_plane(random, 2);
      plane[3] = -(plane[0] + plane[1] + plane[2]);
      cuts.push_back({plane, random.one_in(6) ? Side::kZero : random_side(random)});
    }
    expect_right_throughout(cuts);
  }
}

TEST(Cone, ManyPlanesThroughOneLine) {
  RandomSource random(8);
  for (int round = 0; round < 20; ++round) {
    std::vector<Cut> cuts;
    for (int n = 0; n < 7; ++n) {
      const int a = random.between(-2, 2);
      const int b = random.between(-2, 2);
      cuts.push_back({{a, b, a - b, 0}, random.one_in(5) ? Side::kZero : random_side(random)});
    }
    expect_right_throughout(cuts);
  }
}

TEST(Cone, SmallRandomSystems) {
  RandomSource random(1);
  for (int round = 0; round < 400; ++round) {
    std::vector<Cut> cuts;
    const int bound = random.between(1, 3);
    const int count = random.between(1, 8);
    for (int n = 0; n < count; ++n) {
      // Repetitions and opposites are frequent in grasps.
      if (!cuts.empty() && random.one_in(5)) {
        cuts.push_back({random.pick(cuts).plane, random_side(random)});
      } else {
        cuts.push_back({random_plane(random, bound), random_side(random)});
      }
    }
    expect_right(cuts);
  }
}

// The parts on several sides are what as many cuts leave, with rays in the same order.
TEST(Cone, PartsAreWhatCutsLeave) {
  RandomSource random(4);
  const std::vector<Side> all{Side::kPositive, Side::kZero, Side::kNegative};
  int along_lines = 0;
  int others = 0;
  for (int round = 0; round < 300; ++round) {
    Cone cone;
    for (int n = random.between(0, 6); n > 0; --n) {
      cone.cut(random_plane(random, 2), random_side(random));
    }
    const IntegerVector5 plane = random_plane(random, 2);
    std::vector<Side> sides;
    for (const Side side : all) {
      if (!random.one_in(4)) sides.push_back(side);
    }
    const std::vector<Cone> parts = cone.parts(plane, sides);
    ASSERT_EQ(parts.size(), sides.size());
    for (std::size_t k = 0; k < sides.size(); ++k) {
      Cone cut = cone;
      cut.cut(plane, sides[k]);
      EXPECT_EQ(parts[k].lines(), cut.lines());
      EXPECT_EQ(parts[k].constraint_count(), cut.constraint_count());
      EXPECT_EQ(parts[k].pairs(), k == 0 ? cut.pairs() : 0);
      ASSERT_EQ(parts[k].rays().size(), cut.rays().size());
      for (std::size_t r = 0; r < cut.rays().size(); ++r) {
        EXPECT_EQ(parts[k].rays()[r].x, cut.rays()[r].x);
        EXPECT_EQ(parts[k].rays()[r].tight, cut.rays()[r].tight);
      }
      ++(cut.lines().size() < cone.lines().size() ? along_lines : others);
    }
  }
  EXPECT_GE(along_lines, 50);
  EXPECT_GE(others, 50);
}

TEST(ConeSigns, AgreeWithSubstitution) {
  RandomSource random(3);
  for (int round = 0; round < 300; ++round) {
    Cone cone;
    for (int n = random.between(0, 6); n > 0; --n) {
      cone.cut(random_plane(random, 1), random_side(random));
    }
    const IntegerVector5 plane = random_plane(random, 1);
    bool negative = false;
    bool positive = false;
    for (const IntegerVector5& x : cone.directions()) {
      negative = negative || dot(plane, x) < 0;
      positive = positive || dot(plane, x) > 0;
    }
    const SignRange range = ConeSigns(cone).on(plane);
    EXPECT_EQ(range.negative, negative);
    EXPECT_EQ(range.positive, positive);
    EXPECT_EQ(range.is_nonnegative(), !negative);
    EXPECT_EQ(range.is_nonpositive(), !positive);
    EXPECT_EQ(range.is_zero(), !negative && !positive);
    EXPECT_EQ(range.is_mixed(), negative && positive);
  }
}

// Planes that pass a ray by so little that doubles cannot see on which side, or through it.
TEST(ConeSigns, AreExactWhereDoublesGiveOut) {
  RandomSource random(5);
  for (const unsigned bits : {4U, 60U, 200U, 1100U}) {
    std::size_t cones = 0;
    for (int round = 0; round < 60; ++round) {
      Cone cone;
      for (int n = 0; n < 6; ++n) {
        IntegerVector5 plane = random_plane(random, 9);
        for (Integer& entry : plane) entry = (entry << bits) + random.between(-3, 3);
        cone.cut(plane, random_side(random));
      }
      if (cone.rays().empty() || !cone.lines().empty()) continue;
      ++cones;
      // (a, x) = beside * h on the first ray.
      const IntegerVector5& x = cone.rays()[0].x;
      for (const int beside : {-1, 0, 1}) {
        const IntegerVector5 plane = {x[1] * x[3], -x[0] * x[3], 0, beside, 0};
        SignRange range;
        std::size_t through = 0;
        for (const Ray& ray : cone.rays()) {
          const int sign = dot(plane, ray.x).sign();
          (sign < 0 ? range.negative : sign > 0 ? range.positive : range.zero) = true;
          if (sign == 0) ++through;
        }
        const ConeSigns signs(cone);
        EXPECT_EQ(signs.on(plane).negative, range.negative);
        EXPECT_EQ(signs.on(plane).zero, range.zero);
        EXPECT_EQ(signs.on(plane).positive, range.positive);
        EXPECT_EQ(signs.rays_in(plane).size(), through);
      }
    }
    EXPECT_GE(cones, 20U) << bits;
  }
}

class SpatialRegion : public StrictCone {
 public:
  SpatialRegion() : StrictCone(6) { list_points(); }
  SpatialRegion above(const Row& plane) const {
    SpatialRegion part = *this;
    part.cut(plane, Side::kPositive);
    part.list_points();
    return part;
  }
};

/// Checkers may give up on more points than this (FORMAT.md, section 4), so that engines do.
TEST(StrictCone, NoTreeHasRegionsOfTooManyPoints) {
  std::size_t most = 0;
  int t = 0;
  std::vector<int> tree;
  const bool whole =
      append_tree(SpatialRegion(), tree, [&](const SpatialRegion& region, std::size_t) {
        most = std::max(most, region.points().size());
        using Branch = BranchOf<int, SpatialRegion>;
        if (t == 30) return std::optional<Branch>({t, {}});
        ++t;
        Row moment(8);
        Integer power = 1;
        for (std::size_t k = 0; k < 7; ++k, power *= t) moment[k] = power;
        return std::optional<Branch>({t, {region.above(moment)}});
      });
  EXPECT_FALSE(whole);
  EXPECT_GT(most, 200U);
  EXPECT_LE(most, SpatialRegion::kMostPoints);
}

}  // namespace
}  // namespace stickslip
