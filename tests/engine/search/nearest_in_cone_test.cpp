// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest points of cones by the conditions that they, and no other points, satisfy.
#include "engine/search/nearest_in_cone.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/motion/dense.hpp"
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
    // The point is in the cone: a sum of multiples of its generators, none below 0.
    if (found.generators.empty()) {
      EXPECT_EQ(dot(found.point, found.point), 0);
      continue;
    }
    Eigen::MatrixXd own(3, static_cast<Eigen::Index>(found.generators.size()));
    for (std::size_t k = 0; k < found.generators.size(); ++k) {
      own.col(static_cast<Eigen::Index>(k)) =
          Eigen::Map<const Eigen::Vector3d>(units[found.generators[k]].data());
    }
    const Eigen::Map<const Eigen::Vector3d> point(found.point.data());
    const Eigen::VectorXd multiples = least_squares(own, point);
    EXPECT_NEAR((own * multiples - point).norm(), 0, 1e-8);
    EXPECT_GE(multiples.minCoeff(), -1e-8);
  }
  for (const int count : used) EXPECT_GE(count, 30);
}

}  // namespace nearest_in_cone_test
}  // namespace stickslip
