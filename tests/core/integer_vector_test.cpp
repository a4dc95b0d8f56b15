// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/integer_vector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "random_numbers.hpp"

namespace stickslip {
namespace {

using Vector = IntegerVector<3>;

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

/// a as doubles over its largest entry, by exact quotients.
template <std::size_t n>
std::array<double, n> over_largest(const IntegerVector<n>& a) {
  Integer largest = 1;
  for (const Integer& entry : a) largest = std::max(largest, Integer(abs(entry)));
  std::array<double, n> result;
  for (std::size_t j = 0; j < n; ++j) result[j] = to_double(Rational(a[j], largest));
  return result;
}

TEST(IntegerVector, DoublesNeitherOverflowNorVanishWhateverTheBits) {
  testing::Random random(11);
  for (const unsigned bits : {1U, 53U, 100U, 500U, 512U, 900U, 1024U, 2000U, 20000U}) {
    for (int k = 0; k < 40; ++k) {
      IntegerVector<8> a{};
      for (Integer& entry : a) {
        entry = random.digits(18) * random.integer(-1, 1);
        entry <<= bits;
      }
      a[3] >>= bits / 2;  // entries of very different sizes
      const std::array<double, 8> x = in_doubles(a);
      if (is_zero(a)) {
        EXPECT_EQ(x, (std::array<double, 8>{}));
        continue;
      }
      double largest = 0;
      for (const double entry : x) largest = std::max(largest, std::fabs(entry));
      EXPECT_GE(largest, 0.5);
      EXPECT_LT(largest, 1);
      const std::array<double, 8> exact = over_largest(a);
      for (std::size_t j = 0; j < 8; ++j) {
        EXPECT_NEAR(x[j] / largest, exact[j], 8e-16 * std::fabs(exact[j]) + 1e-300) << bits;
      }
    }
  }
}

TEST(IntegerVector, DoublesOfShortEntriesAreExact) {
  EXPECT_EQ((in_doubles(Vector{3, -4, 0})), (std::array<double, 3>{0.375, -0.5, 0}));
  EXPECT_EQ((in_doubles(Vector{0, 0, 0})), (std::array<double, 3>{}));
}

}  // namespace
}  // namespace stickslip
