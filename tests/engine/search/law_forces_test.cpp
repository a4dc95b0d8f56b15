// SPDX-License-Identifier: GPL-3.0-or-later
// The forces of any law on one region: what is refuted is so for grasps, motions and forces of
// mechanics; what is relaxed balances, within the laws as far as the region knows them.
#include "engine/search/law_forces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "law_cases.hpp"
#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {
namespace law_forces_test {

using test::NaivePlace;
using test::RandomSource;

double real(const Rational& x) {
  return to_double(x);
}

Rational within(RandomSource& random, const Interval& interval) {
  return interval.low + random.between(0, 1) * (interval.high - interval.low);
}

/// The work on y of the force of a contact of one grasp of the box, at the motion d. If it
/// sticks its friction is that which works most.
double work_of_contact(RandomSource& random, const LawContact& c, const RationalRow& d,
                       const RationalRow& y) {
  NaivePlace place{{}, c.place->normal};
  const std::vector<Interval>& geometry = c.place->geometry;
  for (std::size_t j = 0; j < place.normal.size(); ++j) {
    place.position.push_back(within(random, geometry[j]));
  }
  for (std::size_t t = 0; t < c.place->turns.size(); ++t) {
    const Rational e = within(random, geometry[place.position.size() + t]);
    for (std::size_t j = 0; j < place.normal.size(); ++j) {
      place.normal[j] += e * c.place->turns[t].direction[j];
    }
  }
  const Rational depth = dot(place.normal, test::moved(place.position, d));
  const Rational a = within(random, c.preload) - within(random, c.stiffness) * depth;
  if (a.sign() <= 0) return 0;
  const double most =
      real(within(random, c.friction)) * std::sqrt(real(c.squared_length)) * real(a);
  const RationalRow slip = test::naive_slip(place, c.place->normal, d);
  const RationalRow seen = test::naive_slip(place, c.place->normal, y);
  const double size = std::sqrt(real(dot(slip, slip)));
  const double friction =
      size > 0 ? -most * real(dot(slip, seen)) / size : most * std::sqrt(real(dot(seen, seen)));
  return real(a * dot(place.normal, test::moved(place.position, y))) + friction;
}

/// A motion of the region, or nothing if some strict function is 0 there.
std::optional<RationalRow> random_motion(RandomSource& random, const MotionRegion& region) {
  RationalRow x(region.motions() + 2);
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < region.points().size(); ++k) {
    if (!random.one_in(3)) continue;
    used.push_back(k);
    const Rational weight = random.between(1, 3);
    for (std::size_t j = 0; j < x.size(); ++j) x[j] += weight * Rational(region.points()[k][j]);
  }
  if (used.empty() || region.bars(used)) return std::nullopt;
  const Rational h = x[region.motions()];
  x.resize(region.motions());
  for (Rational& entry : x) entry /= h;
  return x;
}

/// Forces of one grasp balance its load, and no contact has more than its spring and its
/// friction allow on the region.
void expect_relaxed(const Law& law, const MotionRegion& region, const Relaxation& found) {
  Reals sum = law.load_at(found.motion[static_cast<Eigen::Index>(law.motions)], 0,
                          Reals::Zero(static_cast<Eigen::Index>(law.motions)));
  double size = sum.norm();
  for (std::size_t i = 0; i < law.contacts.size(); ++i) {
    const LawContact& c = law.contacts[i];
    const CornerRow& row = c.corners.front();
    double v = c.preloads[0] * found.motion[static_cast<Eigen::Index>(law.motions)];
    v -= c.stiffnesses[0] *
         row.normal_rounded.dot(found.motion.head(static_cast<Eigen::Index>(law.motions)));
    const double a = found.normal[i];
    const double slack = 1e-7 * (std::fabs(v) + a + 1);
    EXPECT_GE(a, -slack);
    EXPECT_LE(norm_of(found.friction[i]), c.slopes[0] * a + slack);
    if (region.separation(i) == Separation::kClosed) {
      EXPECT_NEAR(a, v, slack);
    }
    if (region.separation(i) == Separation::kOpen) {
      EXPECT_NEAR(a, 0, slack);
    }
    sum += a * row.normal_rounded;
    for (std::size_t k = 0; k < row.slip_rounded.size(); ++k) {
      sum += found.friction[i][k] * row.slip_rounded[k];
    }
    size += a * c.size;
  }
  EXPECT_LE(sum.norm(), 1e-6 * (size + 1e-3));
  // A slip is broken by the work that friction against it would take more.
  const Reals motion = found.motion.head(static_cast<Eigen::Index>(law.motions));
  for (const auto& [gap, i] : found.slips) {
    const CornerRow& row = law.contacts[i].corners.front();
    Double3 slip{};
    for (std::size_t k = 0; k < row.slip_rounded.size(); ++k) {
      slip[k] = row.slip_rounded[k].dot(motion);
    }
    const double against = -law.contacts[i].slopes[0] * found.normal[i] * norm_of(slip);
    EXPECT_NEAR(gap, dot(found.friction[i], slip) - against, 1e-9);
    EXPECT_LE(gap, found.slips.front().first);
  }
}

/// No grasp, motion and forces of the region do positive work on a twist.
void expect_no_work(RandomSource& random, const GraspLaw& law, const MotionRegion& region,
                    const Row& y) {
  const RationalRow twist(y.begin(), y.end());
  const double size = std::sqrt(real(dot(twist, twist)));
  for (int sample = 0; sample < 8; ++sample) {
    const std::optional<RationalRow> d = random_motion(random, region);
    if (!d) continue;
    double sum = 0;
    for (std::size_t j = 0; j < law.motions; ++j) {
      const Interval& w = law.wrench[j];
      sum += real((twist[j].sign() > 0 ? w.high : w.low) * twist[j]);
    }
    for (const LawContact& c : law.contacts) sum += work_of_contact(random, c, *d, twist);
    EXPECT_LE(sum, 1e-9 * size);
  }
}

TEST(LawForces, RefuteOrBalanceARegion) {
  RandomSource random(91);
  std::array<int, 2> seen{};
  for (int round = 0; round < 600; ++round) {
    const bool in_space = round % 2 == 1;
    GraspBox box = test::random_law_box(random, in_space);
    if (round % 6 < 4) {
      for (UncertainContact& c : box.contacts) c.slope = 0;
      box = box.middle();
    }
    const bool is_one = box.is_point();
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const MotionRegion region = test::random_region(random, law);
    SearchWork work;
    LawForces forces(law, nullptr, work);
    if (!forces.enter(region, 0)) continue;
    const LawForces::Found found = forces.nearest(false);
    if (!found.separated) {
      if (!is_one) continue;
      expect_relaxed(law, region, forces.relaxed(found));
      ++seen[0];
      continue;
    }
    const std::optional<Row> y = forces.confirm(found.twist);
    if (!y) continue;
    ++seen[1];
    EXPECT_TRUE(region.is_refuted(*y, nullptr));
    // Beside it, too, no twist may refute the region that some force works on.
    Integer largest = 0;
    for (const Integer& entry : *y) largest = std::max<Integer>(largest, abs(entry));
    for (int beside = 0; beside < 12; ++beside) {
      Row near = *y;
      for (Integer& entry : near) entry = 4 * entry + random.between(-beside, beside) * largest;
      if (region.is_refuted(near, nullptr)) expect_no_work(random, law, region, near);
    }
  }
  EXPECT_GE(seen[0], 25);
  EXPECT_GE(seen[1], 100);
}

}  // namespace law_forces_test
}  // namespace stickslip
