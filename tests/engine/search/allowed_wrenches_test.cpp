// SPDX-License-Identifier: GPL-3.0-or-later
// The wrenches that a region allows, in doubles, against the exact rule of leaves.
#include "engine/search/allowed_wrenches.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "law_cases.hpp"
#include "rounds.hpp"
#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {
namespace allowed_wrenches_test {

using search_detail::Actions;
using search_detail::AllowedWrench;
using search_detail::AllowedWrenches;
using test::RandomSource;

Row random_twist(RandomSource& random, std::size_t size) {
  Row y(size);
  while (is_zero(y)) {
    for (Integer& entry : y) entry = random.between(-4, 4);
  }
  return y;
}

Reals in_units(const Law& law, const Row& exact) {
  Reals y = in_doubles(exact);
  law.scale(y);
  return y;
}

PullRule random_pull(RandomSource& random, std::size_t motions) {
  std::vector<RationalRow> matrix;
  while (matrix.size() < motions) matrix.push_back(test::random_row(random, motions));
  return PullRule(matrix, test::random_row(random, motions));
}

// Doubles say of no twist that it refutes a region, or that it does not, unless that is so. In
// space they only say no.
TEST(AllowedWrenches, DecideAsTheExactRuleDoes) {
  RandomSource random(251);
  std::array<int, 2> seen{};
  int no_in_space = 0;
  for (int round = 0; round < 800; ++round) {
    const bool in_space = round % 8 == 7;
    GraspBox box = test::random_law_box(random, in_space);
    if (!in_space && random.one_in(3)) box = box.middle();
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const MotionRegion region = test::random_region(random, law);
    if (region.is_barred()) continue;
    const PullRule rule = random_pull(random, law.motions);
    const PullRule* pull = random.one_in(2) ? &rule : nullptr;
    const AllowedWrenches wrenches(law, region, pull);
    for (int k = 0; k < 12; ++k) {
      Row y = random_twist(random, law.motions);
      if (k % 2 == 1) {  // against the load, as twists that refute are
        for (std::size_t j = 0; j < y.size(); ++j) {
          y[j] -= 8 * numerator(Rational(law.wrench[j].low + law.wrench[j].high));
        }
      }
      const std::optional<bool> known = wrenches.are_refuted_by(y);
      if (!known) continue;
      EXPECT_EQ(*known, region.is_refuted(y, pull));
      if (in_space) {
        EXPECT_FALSE(*known);
        ++no_in_space;
      } else {
        ++seen[*known ? 1 : 0];
      }
    }
  }
  EXPECT_GE(seen[0], 500);
  EXPECT_GE(seen[1], 50);
  EXPECT_GE(no_in_space, 200);
}

/// A part of a region on which some contact is closed for all of the box, and perhaps slips
/// into a cone of directions.
MotionRegion narrowed(RandomSource& random, const Law& law, MotionRegion region) {
  const LawContact& c = law.contacts.front();
  if (random.one_in(2)) {
    for (const Row& separation : c.separations) {
      region = std::move(region.halves(separation).front());
    }
  }
  if (c.slip_dimension() == 1 || !c.geometry_is_certain() || random.one_in(3)) return region;
  for (const Row& plane : c.corners.front().slip_planes(law.coordinates())) {
    if (is_zero(plane) || random.one_in(3)) continue;
    region = std::move(region.halves(random.one_in(2) ? plane : negated(plane)).front());
  }
  return std::move(region.slip_children(0).back());
}

/// The most work of all contacts on a twist over the height, among the generators: what a load
/// has to make up for.
double most_work(const Law& law, const MotionRegion& region, const Reals& y) {
  const Actions actions(law, region, y);
  double most = -HUGE_VAL;
  for (std::size_t g = 0; g < region.generators().size(); ++g) {
    double work = 0;
    for (std::size_t i = 0; i < law.contacts.size(); ++i) work += actions.work(i, g);
    most =
        std::max(most, work / region.generators()[g][static_cast<Eigen::Index>(law.motions)]);
  }
  return most;
}

// The bound of doubles is that of the exact rule: a load with a little more work against the
// twist makes it refute the region, and one with a little less does not. Motions are bounded,
// so that every generator has a load. Turned normals have the allowance of the format.
TEST(Actions, BoundAsTheExactRuleDoes) {
  RandomSource random(252);
  int turned = 0;
  int bound = 0;
  for (int round = 0; round < test::rounds(600); ++round) {
    const bool in_space = round % 2 == 1;
    GraspBox box = test::random_law_box(random, in_space);
    if (random.one_in(4)) box = box.middle();
    box.max_motion.assign(box.wrench.size(), 2);
    GraspLaw law(box, NormalLaw::kUnilateral);
    const MotionRegion region = narrowed(random, law, test::random_region(random, law));
    if (region.is_barred()) continue;
    const Row exact = random_twist(random, law.motions);
    const Reals y = in_units(law, exact);
    const double most = most_work(law, region, y);
    if (!std::isfinite(most)) continue;  // there is no motion
    const auto largest = static_cast<std::size_t>(
        std::max_element(exact.begin(), exact.end(),
                         [](const Integer& a, const Integer& b) { return abs(a) < abs(b); }) -
        exact.begin());
    const double scale = y[static_cast<Eigen::Index>(largest)] /
                         (law.unit(largest) * to_double(Rational(exact[largest])));
    Rational square = 0;
    for (const Integer& entry : exact) square += Rational(entry * entry);
    for (const bool refutes : {false, true}) {
      // The work of the load on `exact` is minus this.
      const double beyond = (refutes ? 1 : -1) * 1e-7 * (std::fabs(most) + scale);
      const Rational needed = rational_from_double((most + beyond) / scale);
      for (std::size_t j = 0; j < law.motions; ++j) {
        law.wrench[j] = point_interval(-needed / square * Rational(exact[j]));
      }
      EXPECT_EQ(region.is_refuted(exact, nullptr), refutes);
    }
    for (std::size_t i = 0; i < law.contacts.size(); ++i) {
      if (region.separation(i) == Separation::kOpen) continue;
      turned += in_space && !law.contacts[i].tilt.is_zero() ? 1 : 0;
      const SlipCone& cone = region.slips(i);
      bound += cone.moves && !cone.whole && !cone.sides.empty() ? 1 : 0;
    }
  }
  EXPECT_GE(turned, test::rounds(60));
  EXPECT_GE(bound, test::rounds(30));
}

// The force that is added is one that does the work that was said, within springs and friction.
TEST(Actions, ForcesDoTheWorkThatIsSaid) {
  RandomSource random(253);
  int count = 0;
  for (int round = 0; round < 200; ++round) {
    GraspBox box = test::random_law_box(random, round % 2 == 1);
    if (random.one_in(4)) box = box.middle();
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const MotionRegion region = test::random_region(random, law);
    if (region.is_barred()) continue;
    const Reals y = in_units(law, random_twist(random, law.motions));
    const Actions actions(law, region, y);
    for (std::size_t i = 0; i < law.contacts.size(); ++i) {
      const LawContact& c = law.contacts[i];
      std::vector<double> works(region.generators().size(), 1);
      actions.add_work(i, works);
      for (std::size_t g = 0; g < region.generators().size(); ++g) {
        const bool acts = actions.acts(i, g);
        const double work = actions.work(i, g);
        EXPECT_NEAR(works[g] - 1, work, 1e-9);
        double normal = 0;
        Double3 friction{};
        Reals wrench = Reals::Zero(static_cast<Eigen::Index>(law.motions));
        actions.add_force(i, g, normal, friction, wrench);
        EXPECT_NEAR(wrench.dot(y), work, 1e-9);
        EXPECT_TRUE(acts || wrench.norm() == 0);
        if (actions.is_idle(i, g)) {
          EXPECT_NEAR(work, 0, 1e-12);
        }
        if (region.separation(i) == Separation::kOpen) {
          EXPECT_EQ(normal, 0);
          continue;
        }
        EXPECT_LE(normal, std::max(0.0, region.most_separation(i, g)) + 1e-9);
        EXPECT_LE(norm_of(friction), c.slopes[1] * (1 + c.tilted) * std::fabs(normal) + 1e-9);
        count += acts ? 1 : 0;
      }
    }
  }
  EXPECT_GE(count, 300);
}

// The worst wrench is that of the generator with the most work, over a size that all share.
TEST(AllowedWrenches, TheWorstDoesTheMostWork) {
  RandomSource random(254);
  int count = 0;
  for (int round = 0; round < 200; ++round) {
    const GraspLaw law(test::random_law_box(random, round % 2 == 1), NormalLaw::kUnilateral);
    const MotionRegion region = test::random_region(random, law);
    if (region.is_barred()) continue;
    const PullRule rule = random_pull(random, law.motions);
    const bool has_pull = random.one_in(3);
    const AllowedWrenches wrenches(law, region, has_pull ? &rule : nullptr);
    const Reals y = in_units(law, random_twist(random, law.motions));
    const std::optional<AllowedWrench> worst = wrenches.worst(y);
    if (!worst) continue;
    ++count;
    EXPECT_NEAR(worst->wrench.dot(y), worst->work, 1e-9);
    const Actions actions(law, region, y);
    bool some_are_positive = false;
    for (std::size_t g = 0; g < region.generators().size(); ++g) {
      const Reals& x = region.generators()[g];
      double work = law.load_at(x[static_cast<Eigen::Index>(law.motions)], 0, y).dot(y);
      for (std::size_t i = 0; i < law.contacts.size(); ++i) work += actions.work(i, g);
      some_are_positive = some_are_positive || work > 1e-9;
      if (!worst->against && g == worst->generator) {
        EXPECT_EQ(work > 0, worst->work > 0);
      }
      if (!has_pull) continue;
      // Twists have to be against what the rule excludes, too.
      Reals against = rule.against(region.points()[g]);
      law.scale_function(against);
      normalize(against);
      EXPECT_LE(against.dot(y), worst->work + 1e-9);
    }
    if (some_are_positive) {
      EXPECT_GT(worst->work, 0);
    }
  }
  EXPECT_GE(count, 100);
}

}  // namespace allowed_wrenches_test
}  // namespace stickslip
