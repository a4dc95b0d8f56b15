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

/// By the definition alone: over a common denominator, and without a common divisor.
template <std::size_t n>
IntegerVector<n> naive_multiple(const std::array<Rational, n>& a) {
  Integer common = 1;
  for (const Rational& entry : a) common *= denominator(entry);
  IntegerVector<n> result;
  Integer divisor = 0;
  for (std::size_t j = 0; j < n; ++j) {
    result[j] = numerator(Rational(a[j] * common));
    divisor = gcd(divisor, result[j]);
  }
  for (Integer& entry : result) {
    if (!divisor.is_zero()) entry /= divisor;
  }
  return result;
}

TEST(IntegerVector, PrimitiveMultiplesAreTheSameInAndBeyondMachineWords) {
  testing::Random random(62);
  for (int i = 0; i < 20000; ++i) {
    std::array<Rational, 5> a;
    for (Rational& entry : a) {
      const int kind = random.integer(0, 3);
      if (kind > 0) entry = kind == 1 ? random.small() : random.extreme();
    }
    const IntegerVector<5> expected = naive_multiple(a);
    EXPECT_EQ(primitive_multiple(a), expected);
    IntegerVector<5> scaled = expected;
    const Integer factor = abs(random.border());
    if (factor.is_zero()) continue;
    for (Integer& entry : scaled) entry *= factor;
    EXPECT_EQ(primitive(scaled), expected);
    EXPECT_EQ(primitive(negated(scaled)), negated(expected));
  }
}

}  // namespace
}  // namespace stickslip
