// SPDX-License-Identifier: GPL-3.0-or-later
// Planes of few bits in place of longer ones: where they say a side, the others have it.
#include "engine/search/short_plane.hpp"

#include <gtest/gtest.h>

#include "law_cases.hpp"
#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {
namespace short_plane_test {

using search_detail::are_long;
using search_detail::short_plane;
using test::RandomSource;

std::size_t bits_of(const Row& plane) {
  std::size_t most = 0;
  for (const Integer& entry : plane) {
    if (!entry.is_zero()) most = std::max<std::size_t>(most, msb(abs(entry)) + 1);
  }
  return most;
}

/// A plane near a motion, of long numbers.
Row long_plane(RandomSource& random, const Law& law, const RationalRow& motion, int side) {
  const Integer scale = Integer(1) << 80U;
  Row plane(law.coordinates());
  Rational at = 0;
  for (std::size_t j = 0; j < law.motions; ++j) {
    plane[j] = scale * random.between(-4, 4) + random.between(1, 999);
    at += Rational(plane[j]) * motion[j];
  }
  // The motion is beyond the plane by a little: plane.x at h = 1 is about side / 4.
  const Rational height = side * Rational(scale) / 4 - at;
  plane[law.motions] = numerator(height) / denominator(height);
  return plane;
}

TEST(ShortPlane, HasAllPlanesOnTheSideOfTheMotion) {
  RandomSource random(271);
  int found = 0;
  for (int round = 0; round < 900; ++round) {
    GraspBox box = test::random_law_box(random, round % 2 == 1);
    box.max_motion.assign(box.wrench.size(), Rational(random.between(1, 3), 4));
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const MotionRegion region = MotionRegion::root(law);
    const int side = random.one_in(2) ? 1 : -1;
    RationalRow motion(law.motions);
    for (Rational& entry : motion) entry = Rational(random.between(-2, 2), 16);
    const std::vector<Row> planes{long_plane(random, law, motion, side),
                                  long_plane(random, law, motion, side)};
    EXPECT_TRUE(are_long(planes));
    Row point = primitive_multiple([&] {
      RationalRow x = motion;
      x.emplace_back(1);
      x.emplace_back(0);
      return x;
    }());
    const Row plane = short_plane(law, region, planes, law.scaled(point), side);
    if (is_zero(plane)) continue;
    ++found;
    EXPECT_LE(bits_of(plane), 30U);
    EXPECT_FALSE(are_long({plane}));
    // The part of the region beyond it is on that side of the long ones.
    std::vector<MotionRegion> halves = region.halves(side > 0 ? plane : negated(plane));
    for (const Row& x : halves.front().points()) {
      for (const Row& other : planes) EXPECT_GE(side * dot(other, x).sign(), 0);
    }
  }
  EXPECT_GE(found, 50);
}

}  // namespace short_plane_test
}  // namespace stickslip
