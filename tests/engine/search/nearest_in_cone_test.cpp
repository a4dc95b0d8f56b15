// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest points of cones by the conditions that they, and no other points, satisfy.
#include "engine/search/nearest_in_cone.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "random_grasps.hpp"
#include "stickslip/engine/reals.hpp"

namespace stickslip {
namespace nearest_in_cone_test {

using search_detail::ConePoint;
using search_detail::nearest_in_cone;
using test::RandomSource;

Double3 random_vector(RandomSource& random) {
  Double3 v{};
  while (dot(v, v) == 0) {
    for (double& entry : v) entry = random.between(-4, 4);
  }
  return v;
}

// The rest goes along no generator, and is across the point: so nothing in the cone is nearer.
TEST(NearestInCone, TheRestIsAgainstTheCone) {
  RandomSource random(231);
  std::array<int, 4> used{};
  for (int round = 0; round < 4000; ++round) {
    std::vector<Double3> units;
    for (int k = random.between(1, 6); k > 0; --k) {
      normalize(units.emplace_back(random_vector(random)));
    }
    Double3 target = random_vector(random);
    for (double& entry : target) entry /= random.between(1, 8);
    const ConePoint found = nearest_in_cone(units, target);
    Double3 rest{};
    for (std::size_t j = 0; j < 3; ++j) rest[j] = target[j] - found.point[j];
    for (const Double3& unit : units) EXPECT_LE(dot(unit, rest), 1e-8);
    EXPECT_NEAR(dot(found.point, rest), 0, 1e-8);
    ASSERT_LE(found.generators.size(), 3U);
    ++used[found.generators.size()];
    // The point is in the cone: of its own generators it is the nearest point, too.
    std::vector<Double3> own;
    for (const std::size_t k : found.generators) own.push_back(units[k]);
    if (own.empty()) {
      EXPECT_EQ(dot(found.point, found.point), 0);
      continue;
    }
    const ConePoint again = nearest_in_cone(own, found.point);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(again.point[j], found.point[j], 1e-8);
  }
  for (const int count : used) EXPECT_GE(count, 30);
}

}  // namespace nearest_in_cone_test
}  // namespace stickslip
