// SPDX-License-Identifier: MIT
#include "enclosure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace stickslip_check {
namespace {

/// Numbers of all sizes up to 2^+-`most`, and 0; some are near doubles, some are not.
Rational some(std::mt19937_64& random, int most) {
  Integer num = static_cast<unsigned long>(random() >> (random() % 64));
  if (random() % 2 == 0) num = num * static_cast<unsigned long>(random()) + 1;
  Integer den = random() % 2 == 0 ? Integer(static_cast<unsigned long>(random() | 1U)) : Integer(1);
  const unsigned long shift = random() % static_cast<unsigned>(most);
  (random() % 2 == 0 ? num : den) <<= shift;
  Rational value(random() % 2 == 0 ? num : Integer(-num), den);
  value.canonicalize();
  return value;
}

bool holds(const Enclosure& a, const Rational& x) {
  const auto below = [&](double low) { return std::isinf(low) ? low < 0 : Rational(low) <= x; };
  const auto above = [&](double high) { return std::isinf(high) ? high > 0 : Rational(high) >= x; };
  return below(a.low()) && above(a.high());
}

TEST(Enclosure, HoldsExactResults) {
  std::mt19937_64 random(61);
  std::size_t tight = 0;
  for (int k = 0; k < 20000; ++k) {
    // Beyond 2^1000 an enclosure is of everything, and below 2^-1000 of what is near 0.
    const int most = k % 3 == 0 ? 3000 : 200;
    const Rational x = some(random, most);
    const Rational y = some(random, most);
    const Enclosure a(x);
    const Enclosure b(y);
    ASSERT_TRUE(holds(a, x)) << x;
    ASSERT_TRUE(holds(Enclosure(x.get_num()), x.get_num())) << x;
    ASSERT_TRUE(holds(Enclosure(x.get_num(), 70) * Enclosure(Rational(Integer(1) << 70)),
                      x.get_num()))
        << x;
    ASSERT_TRUE(holds(a + b, x + y)) << x << " " << y;
    ASSERT_TRUE(holds(a - b, x - y)) << x << " " << y;
    ASSERT_TRUE(holds(a * b, x * y)) << x << " " << y;
    ASSERT_TRUE(holds((a - b) * (a + b), (x - y) * (x + y))) << x << " " << y;
    ASSERT_TRUE(holds(larger(a, b), std::max(x, y))) << x << " " << y;
    ASSERT_TRUE(holds(smaller(a, b), std::min(x, y))) << x << " " << y;
    // The bounds of FORMAT.md §6, of x^2 + y^2 and of y |x| times the root of it.
    const Rational square = x * x + y * y;
    ASSERT_TRUE(holds(root_above(a * a + b * b), root_above(square))) << x << " " << y;
    ASSERT_TRUE(holds(times_root_above(b, a * a + b * b),
                      root_above(Rational(y * abs(y) * square))))
        << x << " " << y;
    const Enclosure product = a * b;
    if (product.high() - product.low() < 1e-13 * std::fabs(product.high())) ++tight;
  }
  EXPECT_GT(tight, 10000U);
}

// Sums of products hold what they are exactly, also where nearly all of it cancels.
TEST(Enclosure, HoldsSumsOfProducts) {
  std::mt19937_64 random(62);
  std::size_t tight = 0;
  for (int k = 0; k < 5000; ++k) {
    const int most = k % 3 == 0 ? 3000 : k % 3 == 1 ? 200 : 8;
    std::vector<Enclosure> a;
    std::vector<Enclosure> b;
    Rational sum = 0;
    Rational size = 0;
    const std::size_t count = random() % 7;
    for (std::size_t j = 0; j < count; ++j) {
      const Rational x = some(random, most);
      const bool cancels = j + 1 == count && x != 0 && random() % 2 == 0;
      const Rational y = cancels ? Rational(-sum / x) : some(random, most);
      a.emplace_back(x);
      b.emplace_back(y);
      sum += x * y;
      size += abs(x * y);
    }
    b.emplace_back(Rational(5));  // beyond the shorter one
    const Enclosure found = product(a, b);
    ASSERT_TRUE(holds(found, sum)) << sum;
    if (found.high() - found.low() <= 1e-13 * size.get_d()) ++tight;
  }
  EXPECT_GT(tight, 3000U);
  const Enclosure all(Rational(Integer(1) << 5000));
  EXPECT_TRUE(std::isinf(product(std::vector{all, Enclosure()}, std::vector{Enclosure(), Enclosure()}).high()));
  EXPECT_EQ(product(std::vector<Enclosure>{}, std::vector<Enclosure>{}).high(), 0);
}

TEST(Enclosure, OfZeroIsZero) {
  EXPECT_EQ(Enclosure().low(), 0);
  EXPECT_EQ(Enclosure(Rational(0)).high(), 0);
  EXPECT_EQ(Enclosure(Integer(0), -5000).low(), 0);
  // An enclosure of all numbers stays one, times 0 too.
  const Enclosure all(Rational(Integer(1) << 5000));
  EXPECT_TRUE(std::isinf(all.low()) && std::isinf(all.high()));
  EXPECT_TRUE(std::isinf((all * Enclosure()).high()));
  EXPECT_TRUE(std::isinf((all - all).low()));
  EXPECT_TRUE(std::isinf(root_above(all).high()));
}

}  // namespace
}  // namespace stickslip_check
