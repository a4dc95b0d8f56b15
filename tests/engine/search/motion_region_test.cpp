// SPDX-License-Identifier: GPL-3.0-or-later
// Regions of any law against the letter of the format, which naive_region.hpp has for one grasp
// in the plane; of boxes against the grasps at their corners.
#include "stickslip/engine/motion_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "law_cases.hpp"
#include "naive_region.hpp"
#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {
namespace motion_region_test {

using test::NaiveRegion;
using test::RandomSource;
using test::Rays;

Rays rays_of(const MotionRegion& region) {
  Rays rays;
  for (const Row& x : region.points()) rays.push_back(test::to_rational(vector_of<5>(x)));
  return rays;
}

Row random_row(RandomSource& random, std::size_t size) {
  Row row(size);
  for (Integer& entry : row) entry = random.between(-2, 2);
  return row;
}

/// Any split that a tree may make.
void split_at_random(RandomSource& random, const Problem& problem, MotionRegion& region,
                     NaiveRegion& naive) {
  const auto contact =
      static_cast<std::size_t>(random.between(0, static_cast<int>(problem.size()) - 1));
  if (random.one_in(2)) {
    if (naive.labels[contact] || region.is_barred()) return;
    const int child = random.between(0, 2);
    region = region.slip_children(contact)[static_cast<std::size_t>(child)];
    naive = naive.slip_child(problem, contact, 1 - child);
    return;
  }
  Row plane = random_row(random, 5);
  plane[4] = 0;
  if (random.one_in(2)) plane = row_of(problem.separation_plane(ContactId(contact)));
  if (is_zero(plane)) return;
  const bool first = random.one_in(2);
  region = region.halves(plane)[first ? 0 : 1];
  naive = naive.plane_child(test::to_rational(vector_of<5>(plane)), first);
}

TEST(MotionRegion, AgreesWithTheLetterOfTheFormatInThePlane) {
  RandomSource random(81);
  std::array<int, 3> seen{};
  for (int round = 0; round < 700; ++round) {
    const auto m = static_cast<std::size_t>(random.between(1, 3));
    const Grasp grasp =
        random.one_in(4) ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
    const NormalLaw normal_law =
        random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const LoadedGrasp loaded{grasp, test::small_wrench(random)};
    SCOPED_TRACE(test::describe({loaded, normal_law}));
    const Problem problem(loaded, normal_law);
    const Law law = planar_law(problem);
    MotionRegion region = MotionRegion::root(law);
    NaiveRegion naive = NaiveRegion::root(problem);
    for (int splits = random.between(0, 6); splits > 0; --splits) {
      split_at_random(random, problem, region, naive);
    }
    const Rays rays = rays_of(region);
    const bool is_void =
        naive_is_barred(naive, brute_force_generators(naive.constraints).directions());
    EXPECT_EQ(region.is_barred(), is_void);
    if (is_void) {
      ++seen[0];
      continue;
    }
    for (std::size_t i = 0; i < m; ++i) {
      std::array<int, 3> signs{};
      for (const Vector5& ray : rays) {
        ++signs[static_cast<std::size_t>(
            1 + test::value_at(problem.separation(ContactId(i)), ray).sign())];
      }
      const bool closed = signs[0] == 0;
      if (closed || signs[2] == 0) {
        EXPECT_EQ(region.separation(i), closed ? Separation::kClosed : Separation::kOpen);
      } else {
        EXPECT_EQ(region.separation(i), Separation::kMixed);
      }
      if (region.separation(i) == Separation::kOpen ||
          problem.row(ContactId(i)).friction == 0) {
        continue;
      }
      const std::optional<int> expected = naive_sign(problem, naive, rays, i);
      const std::optional<Sign> sign = region.slip_sign(i);
      ASSERT_EQ(sign.has_value(), expected.has_value());
      if (sign) {
        EXPECT_EQ(to_int(*sign), *expected);
      }
    }
    for (int leaves = 0; leaves < 4; ++leaves) {
      const TwistLeaf leaf{random_row(random, 3)};
      const bool holds = naive_refutes(problem, naive, rays, leaf);
      EXPECT_EQ(region.is_refuted(leaf.twist, nullptr), holds);
      ++seen[holds ? 1 : 2];
    }
  }
  for (const int count : seen) EXPECT_GE(count, 40);
}

/// The grasp at the corner of a box that a number says, by its digits in base 2. Only laws and
/// the load of it are uncertain.
LoadedGrasp at_corner(const GraspBox& box, unsigned number) {
  GraspBox corner = box;
  for_each_number(corner, [&](Interval& interval) {
    if (interval.low == interval.high) return;
    interval = point_interval(number % 2 == 1 ? interval.high : interval.low);
    number /= 2;
  });
  return loaded_of(corner);
}

// A twist that refutes a region for a box does so for every grasp of it. If it does not, it
// fails for one at a corner, as long as rows are certain: the bounds are those of a corner.
TEST(MotionRegion, ATwistRefutesABoxWhereItRefutesAllItsCorners) {
  RandomSource random(82);
  std::array<int, 2> seen{};
  for (int round = 0; round < 1500; ++round) {
    const auto m = static_cast<std::size_t>(random.between(1, 2));
    GraspBox box =
        box_of(LoadedGrasp{test::degenerate_grasp(random, m), test::small_wrench(random)});
    unsigned uncertain = 0;
    const Rational eighth(1, 8);
    const auto widen = [&](Interval& interval) {
      if (uncertain == 5 || random.one_in(2) || interval.low.is_zero()) return;
      interval = {interval.low - eighth, interval.high + eighth};
      ++uncertain;
    };
    for (UncertainContact& c : box.contacts) {
      widen(c.friction);
      widen(c.preload);
      widen(c.stiffness);
    }
    for (Interval& component : box.wrench) widen(component);
    const GraspLaw law(box, NormalLaw::kUnilateral);
    MotionRegion region = MotionRegion::root(law);
    std::vector<Row> planes;
    for (int cuts = random.between(1, 5); cuts > 0; --cuts) {
      Row plane = random_row(random, 5);
      plane[4] = 0;
      if (is_zero(plane)) continue;
      region = region.halves(plane)[0];
      planes.push_back(std::move(plane));
    }
    if (region.is_barred()) continue;
    const Rays rays = rays_of(region);
    const TwistLeaf leaf{random_row(random, 3)};
    const bool is_refuted = region.is_refuted(leaf.twist, nullptr);
    bool holds_at_corners = true;
    bool is_sharp = true;  // no bound is 0 at a corner, which more or fewer rays may share
    for (unsigned corner = 0; corner < 1U << uncertain; ++corner) {
      const Problem problem(at_corner(box, corner), NormalLaw::kUnilateral);
      NaiveRegion naive = NaiveRegion::root(problem);
      for (const Row& plane : planes) {
        naive = naive.plane_child(test::to_rational(vector_of<5>(plane)), true);
      }
      holds_at_corners = holds_at_corners && naive_refutes(problem, naive, rays, leaf);
      for (const Rational& bound : naive_bounds(problem, naive, rays, leaf)) {
        is_sharp = is_sharp && !bound.is_zero();
      }
    }
    EXPECT_TRUE(holds_at_corners || !is_refuted);
    EXPECT_TRUE(is_refuted || !holds_at_corners || !is_sharp);
    if (holds_at_corners && is_sharp && uncertain > 0) ++seen[0];
    if (!holds_at_corners && !is_refuted) ++seen[1];
  }
  EXPECT_GE(seen[0], 5);
  EXPECT_GE(seen[1], 100);
}

/// The most work on y that the force of a = 1 does, with friction to any side.
double most_work(const UncertainContact& c, const RationalRow& y) {
  const RationalRow p{c.position[0].low, c.position[1].low, c.position[2].low};
  const test::NaivePlace place{p, c.normal};
  const RationalRow slip = test::naive_slip(place, c.normal, y);
  const double steepness = to_double(c.friction.low * c.friction.low * dot(c.normal, c.normal));
  return to_double(dot(c.normal, test::moved(p, y))) +
         std::sqrt(steepness * to_double(dot(slip, slip)));
}

// In space, where it is not known how anything slips, friction acts to any side with mu times
// the normal force. The exact rule is the sign of bounds that doubles show but where they
// vanish.
TEST(MotionRegion, FrictionInSpaceActsToAnySide) {
  RandomSource random(83);
  std::array<int, 2> seen{};
  for (int round = 0; round < 200; ++round) {
    GraspBox box = test::random_law_box(random, true);
    for (UncertainContact& c : box.contacts) c.slope = 0;
    box = box.middle();
    const GraspLaw law(box, NormalLaw::kUnilateral);
    MotionRegion region = MotionRegion::root(law);
    for (const LawContact& c : law.contacts) {
      const int child = random.between(0, 3);
      if (child != 0) region = region.halves(c.separations.front())[child == 3 ? 1 : 0];
    }
    if (region.is_barred()) continue;
    for (int leaves = 0; leaves < 6; ++leaves) {
      Row y = random_row(random, 6);
      // Against the load, and as far as it goes along the normals of contacts that press.
      for (const LawContact& c : law.contacts) {
        if (random.one_in(2)) continue;
        for (std::size_t j = 0; j < 6; ++j) {
          y[j] -= random.between(1, 6) * numerator(c.corners.front().normal[j]);
        }
      }
      const RationalRow twist(y.begin(), y.end());
      double worst = -HUGE_VAL;
      double nearest = HUGE_VAL;
      for (const Row& point : region.points()) {
        Integer largest = 0;
        for (const Integer& entry : point) largest = std::max<Integer>(largest, abs(entry));
        RationalRow x;
        for (const Integer& entry : point) x.emplace_back(entry, largest);
        const double h = to_double(x[6]);
        double bound = 0;
        for (std::size_t j = 0; j < 6; ++j) {
          bound += h * to_double(twist[j] * box.wrench[j].low);
        }
        for (std::size_t i = 0; i < law.contacts.size(); ++i) {
          const LawContact& c = law.contacts[i];
          const Row& plane = c.separations.front();
          const double v = to_double(dot(RationalRow(plane.begin(), plane.end()), x) *
                                     c.separation_factors.front());
          const double work = most_work(box.contacts[i], twist);
          if (region.separation(i) == Separation::kClosed) bound += work * v;
          if (region.separation(i) == Separation::kMixed) {
            bound += std::max(0.0, work) * std::max(0.0, v);
          }
        }
        // At h = 0, where no solution is, it may vanish.
        constexpr double kRounding = 1e-9;
        worst = std::max(worst, h == 0 && bound < kRounding ? -1.0 : bound);
        if (h > 0) nearest = std::min(nearest, std::fabs(bound));
      }
      if (nearest < 1e-6) continue;
      EXPECT_EQ(region.is_refuted(y, nullptr), worst < 0);
      ++seen[worst < 0 ? 0 : 1];
    }
  }
  EXPECT_GE(std::min(seen[0], seen[1]), 20);
}

}  // namespace motion_region_test
}  // namespace stickslip
