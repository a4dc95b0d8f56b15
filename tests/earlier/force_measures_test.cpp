// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes against closed forms, affine maps and sums of parts; least forces and margins against
// closed forms, the facets of wrench spaces, which are computed in another way, and PCR.
#include "stickslip/earlier/force_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_source.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/problem.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip {
namespace {
namespace force_measures {  // robustness_test.cpp has helpers of the same names

using bench::RandomSource;

constexpr std::size_t kMany = 20000;

UncertainContact finger(const RationalRow& p, const RationalRow& n, const Rational& friction) {
  UncertainContact c;
  for (const Rational& x : p) c.position.push_back(point_interval(x));
  c.normal = n;
  c.friction = point_interval(friction);
  c.stiffness = point_interval(1);
  return c;
}

GraspBox grasp_of(std::vector<UncertainContact> contacts, const RationalRow& load) {
  GraspBox grasp{std::move(contacts), {}, {}};
  for (const Rational& w : load) grasp.wrench.push_back(point_interval(w));
  grasp.check();
  return grasp;
}

/// A unit vector of small numbers.
RationalRow unit(RandomSource& random) {
  static const std::vector<RationalRow> some{
      {1, 0}, {0, 1}, {{3, 5}, {4, 5}}, {{4, 5}, {3, 5}}};
  RationalRow n = some[static_cast<std::size_t>(random.between(0, 3))];
  for (Rational& x : n) {
    if (random.between(0, 1) == 1) x = -x;
  }
  return n;
}

GraspBox planar_grasp(RandomSource& random, int count) {
  std::vector<UncertainContact> contacts;
  for (int i = 0; i < count; ++i) {
    contacts.push_back(finger({random.between(-3, 3), random.between(-3, 3)}, unit(random),
                              Rational(random.between(0, 4), 3)));
  }
  return grasp_of(std::move(contacts),
                  {random.between(-2, 2), random.between(-2, 2), random.between(-3, 3)});
}

Rational sum_of_balance(const GraspBox& grasp, const std::vector<RationalRow>& forces) {
  RationalRow rest;
  for (const Interval& w : grasp.wrench) rest.push_back(w.low);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    add_multiple(rest, 1, wrench_at(grasp.contacts[i].point(), forces[i]));
  }
  return dot(rest, rest);
}

/// Whether a force is in the cone of its contact. Requires a unit normal.
bool is_in_cone(const UncertainContact& contact, const RationalRow& force) {
  const Rational along = dot(force, contact.normal);
  const Rational& mu = contact.friction.low;
  return along.sign() >= 0 && dot(force, force) <= (1 + mu * mu) * along * along;
}

TEST(HullVolume, ClosedForms) {
  for (std::size_t n = 1; n <= 6; ++n) {
    Rational factorial = 1;
    for (std::size_t k = 2; k <= n; ++k) factorial *= Rational(static_cast<long>(k));
    std::vector<RationalRow> cross;
    std::vector<RationalRow> corners;
    for (std::size_t j = 0; j < n; ++j) {
      for (const int sign : {1, -1}) {
        cross.emplace_back(n);
        cross.back()[j] = sign;
      }
    }
    for (unsigned bits = 0; bits < (1U << n); ++bits) {
      RationalRow& x = corners.emplace_back();
      for (std::size_t j = 0; j < n; ++j) x.emplace_back((bits >> j) & 1U ? 2 : -1);
    }
    Rational power = 1;
    Rational threes = 1;
    for (std::size_t k = 0; k < n; ++k) {
      power *= 2;
      threes *= 3;
    }
    // The cross-polytope has the volume 2^n / n!, a cube of side 3 3^n.
    EXPECT_EQ(hull_volume(cross, kMany), power / factorial);
    // Points inside, on a face and twice change nothing.
    if (n <= 5) {
      corners.emplace_back(n, Rational(1, 2));
      corners.push_back(corners.front());
      corners.emplace_back(n, 0);
      corners.back()[0] = 2;
      EXPECT_EQ(hull_volume(corners, kMany), threes);
    }
    // Without the point 0 the hull of these is a simplex on one side, with it one of 1 / n!.
    std::vector<RationalRow> axes;
    for (std::size_t j = 0; j < n; ++j) {
      axes.emplace_back(n);
      axes.back()[j] = 1;
    }
    EXPECT_EQ(hull_volume(axes, kMany), 1 / factorial);
    axes.pop_back();
    EXPECT_EQ(hull_volume(axes, kMany), 0);
  }
  EXPECT_EQ(hull_volume({}, kMany), 0);
  EXPECT_FALSE(hull_volume({{1, 0}, {0, 1}, {-1, -1}}, 1).has_value());
}

TEST(HullVolume, ScalesByDeterminantsAndAddsUp) {
  RandomSource random(3);
  for (int round = 0; round < 20; ++round) {
    std::vector<RationalRow> points;
    std::vector<RationalRow> sheared;
    std::vector<RationalRow> above;
    std::vector<RationalRow> below;
    for (int k = 0; k < 9; ++k) {
      RationalRow x;
      for (int j = 0; j < 4; ++j) x.emplace_back(random.between(-4, 4));
      points.push_back(x);
      sheared.push_back({3 * x[0] + x[3], x[1] - 2 * x[2], x[2] + x[0], 5 * x[3]});
    }
    const Rational volume = *hull_volume(points, kMany);
    EXPECT_EQ(hull_volume(sheared, kMany), 15 * volume);
    // A plane through 0 cuts segments between points where both parts have their corners.
    for (const RationalRow& p : points) {
      if (p[0].sign() >= 0) above.push_back(p);
      if (p[0].sign() <= 0) below.push_back(p);
      for (const RationalRow& q : points) {
        if (p[0].sign() <= 0 || q[0].sign() >= 0) continue;
        RationalRow cut = p;
        add_multiple(cut, p[0] / (p[0] - q[0]), q);
        add_multiple(cut, -p[0] / (p[0] - q[0]), p);
        above.push_back(cut);
        below.push_back(cut);
      }
    }
    EXPECT_EQ(*hull_volume(above, kMany) + *hull_volume(below, kMany), volume);
  }
}

TEST(WrenchSpaceVolume, IsOfCones) {
  // Opposite fingers: the hull of (1, +-mu, 0 +- mu), and of (-1, +-mu, -+mu), and of 0.
  // In these coordinates, the points are (1, s, -s) mu at (-1, 0) and (-1, s, s) at (1, 0):
  // a tetrahedron with opposite edges of 2 sqrt 2 mu at right angles, 2 apart.
  const GraspBox pinch = grasp_of(
      {finger({-1, 0}, {1, 0}, {1, 2}), finger({1, 0}, {-1, 0}, {1, 2})}, RationalRow(3));
  const auto found = wrench_space_volume(pinch, 1, kMany);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->lower, found->upper);
  EXPECT_EQ(found->lower, Rational(2, 3));  // 2 * (2 sqrt 2 mu)^2 / 6
  EXPECT_EQ(wrench_space_volume(pinch, 3, kMany)->lower, Rational(2, 9));
  // In space three fingers around a circle, with discs: bounds are apart by the polygons.
  const auto pads = [](const Rational& mu) {
    return grasp_of({finger({1, 0, 0}, {-1, 0, 0}, mu),
                     finger({{-3, 5}, {4, 5}, 0}, {{3, 5}, {-4, 5}, 0}, mu),
                     finger({{-3, 5}, {-4, 5}, 0}, {{3, 5}, {4, 5}, 0}, mu)},
                    RationalRow(6));
  };
  const auto round = wrench_space_volume(pads({1, 2}), 1, kMany);
  ASSERT_TRUE(round.has_value());
  EXPECT_GT(round->lower, 0);
  EXPECT_LT(round->lower, round->upper);
  EXPECT_LT(round->upper, 2 * round->lower);
  EXPECT_EQ(wrench_space_volume(pads(0), 1, kMany)->upper, 0);
  // Torques are three of the six coordinates.
  const auto longer = wrench_space_volume(pads({1, 2}), 2, kMany);
  EXPECT_EQ(8 * longer->lower, round->lower);
  EXPECT_EQ(8 * longer->upper, round->upper);
}

TEST(LeastForces, AreTheGaugesOfWrenchSpaces) {
  // The least sum is the least s with -w in s times the space, by its facets: the largest
  // u.(-w) / h, if no facet through 0 has u.(-w) > 0.
  RandomSource random(11);
  int held = 0;
  int none = 0;
  for (int round = 0; round < 60; ++round) {
    const GraspBox grasp = planar_grasp(random, random.between(2, 5));
    std::vector<Contact> contacts;
    for (const UncertainContact& c : grasp.contacts) {
      contacts.push_back({{c.position[0].low, c.position[1].low},
                          {c.normal[0], c.normal[1]},
                          c.friction.low,
                          1,
                          0});
    }
    const RationalRow load{grasp.wrench[0].low, grasp.wrench[1].low, grasp.wrench[2].low};
    const Problem problem({Grasp(contacts), {load[0], load[1], load[2]}},
                          NormalLaw::kUnilateral);
    for (const ForceBound bound : {ForceBound::kL1, ForceBound::kLinf}) {
      std::optional<Rational> gauge = 0;
      for (const HalfSpace& facet : wrench_space_facets(problem, bound)) {
        Rational reach = 0;
        for (std::size_t j = 0; j < 3; ++j) reach -= Rational(facet.normal[j]) * load[j];
        if (reach.sign() <= 0) continue;
        if (facet.offset.is_zero()) gauge.reset();
        if (gauge) gauge = std::max(*gauge, Rational(reach / facet.offset));
      }
      // A flat space has the facets of one plane alone.
      const LeastForce found = least_force(grasp, bound);
      if (!found.balances) {
        ++none;
        EXPECT_FALSE(found.upper.has_value());
        continue;
      }
      ++held;
      ASSERT_TRUE(found.upper.has_value());
      EXPECT_EQ(found.lower, *found.upper);
      ASSERT_TRUE(gauge.has_value());
      EXPECT_GE(found.lower, *gauge);
      const bool is_flat = wrench_space_facets(problem, bound).size() == 2;
      if (!is_flat) {
        EXPECT_EQ(found.lower, *gauge);
      }
      Rational sum = 0;
      Rational largest = 0;
      for (std::size_t i = 0; i < found.forces.size(); ++i) {
        EXPECT_TRUE(is_in_cone(grasp.contacts[i], found.forces[i]));
        const Rational along = dot(found.forces[i], grasp.contacts[i].normal);
        sum += along;
        largest = std::max(largest, along);
      }
      EXPECT_EQ(sum_of_balance(grasp, found.forces), 0);
      EXPECT_EQ(bound == ForceBound::kL1 ? sum : largest, *found.upper);
    }
  }
  EXPECT_GE(held, 20);
  EXPECT_GE(none, 20);
}

TEST(LeastForces, InSpace) {
  // A pinch with friction 1/2 holds a weight of 1 along (3/5, 4/5) across it: 1 each, sum 2.
  const auto pinch = [](const RationalRow& load) {
    return grasp_of(
        {finger({-1, 0, 0}, {1, 0, 0}, {1, 2}), finger({1, 0, 0}, {-1, 0, 0}, {1, 2})}, load);
  };
  const GraspBox held = pinch({0, {3, 5}, {-4, 5}, 0, 0, 0});
  for (const ForceBound bound : {ForceBound::kL1, ForceBound::kLinf}) {
    const Rational least = bound == ForceBound::kL1 ? 2 : 1;
    const LeastForce found = least_force(held, bound);
    ASSERT_TRUE(found.upper.has_value());
    EXPECT_LE(found.lower, least);
    EXPECT_GE(*found.upper, least);
    EXPECT_LE(*found.upper - found.lower, Rational(1, 100000));
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(is_in_cone(held.contacts[i], found.forces[i]));
    }
    EXPECT_EQ(sum_of_balance(held, found.forces), 0);
    // A twist about the line of the two is not resisted.
    EXPECT_FALSE(least_force(pinch({0, 0, 0, 1, 0, 0}), bound).balances);
    EXPECT_EQ(least_force(pinch(RationalRow(6)), bound).upper, Rational(0));
    EXPECT_FALSE(least_force(grasp_of({}, {0, 0, -1, 0, 0, 0}), bound).balances);
  }
}

TEST(InternalMargin, IsTheDistanceOfPcr) {
  // A pinch has d = f / (1 + sqrt(1 + mu^2) / mu): 3/8 for mu = 3/4 and f = 1.
  const GraspBox pinch = grasp_of(
      {finger({-1, 0}, {1, 0}, {3, 4}), finger({1, 0}, {-1, 0}, {3, 4})}, RationalRow(3));
  const InternalMargin found = internal_margin(pinch);
  EXPECT_EQ(found.lower, Rational(3, 8));
  EXPECT_EQ(found.upper, Rational(3, 8));
  EXPECT_EQ(found.forces, (std::vector<RationalRow>{{{5, 8}, 0}, {{-5, 8}, 0}}));
  // In space the pinch leaves a turn free, so that PCR is 0; the margin is the same.
  const GraspBox in_space =
      grasp_of({finger({-1, 0, 0}, {1, 0, 0}, {3, 4}), finger({1, 0, 0}, {-1, 0, 0}, {3, 4})},
               RationalRow(6));
  const InternalMargin there = internal_margin(in_space);
  EXPECT_LE(there.lower, Rational(3, 8));
  EXPECT_GE(there.upper, Rational(3, 8));
  EXPECT_LE(there.upper - there.lower, Rational(1, 10000));
  EXPECT_FALSE(potential_contact_robustness(in_space).has_full_rank);
  // Without friction normal forces are 1/2, half of the largest.
  const GraspBox smooth =
      grasp_of({finger({-1, 0}, {1, 0}, 0), finger({1, 0}, {-1, 0}, 0)}, RationalRow(3));
  EXPECT_EQ(internal_margin(smooth).lower, Rational(1, 2));
  const GraspBox heavy =
      grasp_of({finger({-1, 0}, {1, 0}, {1, 2}), finger({1, 0}, {-1, 0}, {1, 2})}, {0, -2, 0});
  EXPECT_FALSE(internal_margin(heavy).balances);
  RobustnessOptions strong;
  strong.most_forces = {3};
  EXPECT_TRUE(internal_margin(heavy, strong).balances);
  RandomSource random(5);
  int compared = 0;
  for (int round = 0; round < 30; ++round) {
    const GraspBox grasp = planar_grasp(random, random.between(2, 5));
    const Robustness pcr = potential_contact_robustness(grasp);
    const InternalMargin margin = internal_margin(grasp);
    if (pcr.has_full_rank) {
      EXPECT_EQ(pcr.balances, margin.balances);
    }
    if (!pcr.best) continue;
    ++compared;
    EXPECT_EQ(pcr.best->distance, margin.lower);
    EXPECT_EQ(pcr.best->forces, margin.forces);
    EXPECT_LE(margin.lower, margin.upper);
  }
  EXPECT_GE(compared, 3);
}

TEST(Pyramids, ComeNearTheRoundCone) {
  // A pinch with f = 4 carries (3/4, 3/4) at each finger, at 45 degrees between the edges of a
  // pyramid of four: s - 5/3 d >= (3/4 + 3/4) / mu = 2 and 4 - s >= d, so d = 3/4. With the
  // round cone it is (4 - sqrt 2) 3/8.
  const GraspBox pinch =
      grasp_of({finger({-1, 0, 0}, {1, 0, 0}, {3, 4}), finger({1, 0, 0}, {-1, 0, 0}, {3, 4})},
               {0, {-3, 2}, {-3, 2}, 0, 0, 0});
  RobustnessOptions options;
  options.most_forces = {4};
  options.edges = 4;
  const InternalMargin four = internal_margin(pinch, options);
  EXPECT_EQ(four.lower, Rational(3, 4));
  EXPECT_EQ(four.upper, Rational(3, 4));
  EXPECT_EQ(least_force(pinch, ForceBound::kL1, 4).upper, Rational(4));
  EXPECT_EQ(least_force(pinch, ForceBound::kL1, 4).lower, 4);
  EXPECT_EQ(least_force(pinch, ForceBound::kLinf, 4).lower, 2);
  // Three pads on a ball and one from below, under a load.
  const GraspBox pads = grasp_of({finger({1, 0, 0}, {-1, 0, 0}, {1, 2}),
                                  finger({{-3, 5}, {4, 5}, 0}, {{3, 5}, {-4, 5}, 0}, {1, 2}),
                                  finger({{-3, 5}, {-4, 5}, 0}, {{3, 5}, {4, 5}, 0}, {1, 2}),
                                  finger({{3, 5}, 0, {-4, 5}}, {{-3, 5}, 0, {4, 5}}, {1, 2})},
                                 {{1, 20}, {1, 30}, {-1, 10}, 0, 0, {1, 50}});
  RobustnessOptions round;
  const Robustness cone = potential_contact_robustness(pads, round);
  const Robustness whole = potential_grasp_robustness(pads, round);
  const LeastForce least = least_force(pads, ForceBound::kL1);
  const auto volume = wrench_space_volume(pads, 1, kMany);
  ASSERT_TRUE(cone.best && whole.best && least.upper && volume);
  std::optional<Rational> gap;
  std::optional<Rational> excess;
  Rational before = 0;
  for (const std::size_t edges : {4, 8, 32}) {
    round.edges = edges;
    const Robustness pyramid = potential_contact_robustness(pads, round);
    const Robustness pgr = potential_grasp_robustness(pads, round);
    ASSERT_TRUE(pyramid.best && pgr.best);
    EXPECT_LE(pyramid.upper, pyramid.lower * Rational(1000001, 1000000));
    EXPECT_LE(pyramid.lower, cone.upper);
    EXPECT_LE(pgr.lower, whole.upper);
    EXPECT_GE(pgr.upper, pyramid.lower);
    const Rational apart = cone.upper - pyramid.lower;
    EXPECT_TRUE(!gap || apart < *gap);
    gap = apart;
    const LeastForce more = least_force(pads, ForceBound::kL1, edges);
    EXPECT_EQ(more.lower, *more.upper);
    EXPECT_GE(*more.upper, least.lower);
    EXPECT_TRUE(!excess || *more.upper - least.lower < *excess);
    excess = *more.upper - least.lower;
    if (edges > 8) continue;
    const auto inside = wrench_space_volume(pads, 1, kMany, edges);
    ASSERT_TRUE(inside.has_value());
    EXPECT_EQ(inside->lower, inside->upper);
    EXPECT_GT(inside->lower, before);
    EXPECT_LE(inside->lower, volume->lower);
    before = inside->lower;
  }
  EXPECT_EQ(before, volume->lower);
  EXPECT_LE(*gap, cone.upper / 100);
  EXPECT_LE(*excess, least.lower / 100);
}

TEST(ForceMeasures, NeedUnitNormals) {
  const GraspBox slanted = grasp_of({finger({0, 0}, {1, 1}, 1)}, RationalRow(3));
  EXPECT_THROW(wrench_space_volume(slanted, 1, kMany), InputError);
  EXPECT_THROW(least_force(slanted, ForceBound::kL1), InputError);
  EXPECT_THROW(internal_margin(slanted), InputError);
}

}  // namespace force_measures
}  // namespace
}  // namespace stickslip
