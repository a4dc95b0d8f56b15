// SPDX-License-Identifier: GPL-3.0-or-later
// Sums in pairs and motions without denominators, against plain arithmetic.
#include "engine/equilibrium/long_rationals.hpp"

#include <gtest/gtest.h>

#include "random_grasps.hpp"
#include "stickslip/core/contact_row.hpp"

namespace stickslip {
namespace long_rationals_test {

using test::RandomSource;

TEST(LongRationals, SumsInPairsAreSums) {
  RandomSource random(301);
  for (int count = 0; count < 40; ++count) {
    std::vector<Rational> terms;
    Rational sum = 0;
    while (terms.size() < static_cast<std::size_t>(count)) {
      sum += terms.emplace_back(random.between(-99, 99), random.between(1, 99));
    }
    EXPECT_EQ(sum_in_pairs(terms), sum);
  }
}

TEST(LongRationals, ScaledTwistsHaveIntegersAndTheSameForces) {
  RandomSource random(302);
  for (int round = 0; round < 60; ++round) {
    const auto entry = [&] { return Rational(random.between(-9, 9), random.between(1, 12)); };
    const Twist d{entry(), entry(), entry()};
    const ScaledTwist scaled(d);
    EXPECT_GT(scaled.scale, 0);
    Integer common = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational number = coordinates(scaled.twist)[j];
      EXPECT_EQ(number, scaled.scale * coordinates(d)[j]);
      EXPECT_EQ(denominator(number), 1);
      common = gcd(common, numerator(number));
    }
    EXPECT_EQ(gcd(common, numerator(scaled.scale)), 1);  // none is smaller
    for (const ContactRow& row : contact_rows(test::generic_grasp(random, 2))) {
      EXPECT_EQ(scaled.normal_coefficient(row),
                scaled.scale * (row.preload - row.stiffness * power(row.normal, d)));
    }
  }
}

}  // namespace long_rationals_test
}  // namespace stickslip
