// SPDX-License-Identifier: GPL-3.0-or-later
// The corner at which a load is lost soonest, on a grasp that says so in closed form.
#include "engine/degree/weakest_corners.hpp"

#include <gtest/gtest.h>

#include "box_cases.hpp"
#include "engine/degree/newton.hpp"
#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {
namespace {

/// They press with 9/10 to 11/10.
GraspBox loaded_pads(bool in_space, const Rational& weight) {
  WrenchBox load(in_space ? 6 : 3);
  load[1] = point_interval(-weight);
  return test::two_pads({Rational(9, 10), Rational(11, 10)}, load);
}

// The weight is held up to mu P of each pad: 2 * 2/5 * 9/10 of 3/4 where both are least.
TEST(WeakestCorners, AreThoseOfTheLeastFrictionAndPreload) {
  for (const bool in_space : {false, true}) {
    const GraspBox box = loaded_pads(in_space, Rational(3, 4));
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const RoundedBox rounded(law);
    const auto middle = Newton(rounded.at(rounded.middle())).solve_thoroughly(3);
    ASSERT_TRUE(middle);
    for (const std::size_t descents : {1, 3}) {
      const auto corners = weakest_corners(rounded, *middle, descents);
      ASSERT_FALSE(corners.empty());
      EXPECT_NEAR(corners.front().multiple, 0.96, 0.005);
      for (Eigen::Index n = 0; n < corners.front().at.size(); ++n) {
        EXPECT_EQ(corners.front().at[n], -1) << n;
      }
      for (std::size_t k = 1; k < corners.size(); ++k) {
        EXPECT_LE(corners[k - 1].multiple, corners[k].multiple);
      }
    }
  }
}

TEST(WeakestCorners, ThereAreNoneWithoutALoad) {
  const GraspBox box = loaded_pads(false, 0);
  const GraspLaw law(box, NormalLaw::kUnilateral);
  const RoundedBox rounded(law);
  const auto middle = Newton(rounded.at(rounded.middle())).solve_thoroughly(3);
  ASSERT_TRUE(middle);
  EXPECT_TRUE(weakest_corners(rounded, *middle, 2).empty());
}

}  // namespace
}  // namespace stickslip
