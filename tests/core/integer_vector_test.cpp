// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/integer_vector.hpp"

#include <gtest/gtest.h>

#include "random_numbers.hpp"

namespace stickslip {
namespace {

using Vector = IntegerVector<3>;

TEST(IntegerVector, Primitive) {
  EXPECT_EQ(primitive(Vector{6, -9, 0}), (Vector{2, -3, 0}));
  EXPECT_EQ(primitive(Vector{0, 0, -5}), (Vector{0, 0, -1}));
  EXPECT_EQ(primitive(Vector{0, 0, 0}), (Vector{0, 0, 0}));
  EXPECT_EQ(primitive(Vector{4, 6, 9}), (Vector{4, 6, 9}));
}

TEST(IntegerVector, DotNegatedIsZero) {
  EXPECT_EQ(dot(Vector{1, 2, 3}, Vector{5, 7, 11}), 52);
  EXPECT_EQ(negated(Vector{1, -2, 0}), (Vector{-1, 2, 0}));
  EXPECT_TRUE(is_zero(Vector{0, 0, 0}));
  EXPECT_FALSE(is_zero(Vector{0, 0, 1}));
}

TEST(IntegerVector, PrimitiveMultipleOfRationals) {
  EXPECT_EQ(primitive_multiple(Vector3{Rational(1, 2), Rational(-1, 3), 0}),
            (Vector{3, -2, 0}));
  EXPECT_EQ(primitive_multiple(Vector3{0, 0, 0}), (Vector{0, 0, 0}));
  testing::Random random(61);
  for (int i = 0; i < 500; ++i) {
    const Vector3 a{random.small(), random.big(20), random.small()};
    const Vector v = primitive_multiple(a);
    EXPECT_EQ(primitive(v), v);
    // Parallel, and not opposite.
    Rational product = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = (j + 1) % 3;
      EXPECT_EQ(a[j] * Rational(v[k]), a[k] * Rational(v[j]));
      product += a[j] * Rational(v[j]);
    }
    EXPECT_EQ(product.is_zero(), is_zero(v));
    EXPECT_GE(product, 0);
  }
}

}  // namespace
}  // namespace stickslip
