// SPDX-License-Identifier: GPL-3.0-or-later
// The fixed-width fused step (a b - c d) / e and the product comparison against GMP, at the
// ends of their range and at random sizes: exact where the quotient fits, refused where not.
#include "integer_tier.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace stickslip::lp_detail {
namespace {

template <class Tier>
constexpr int kWidth = std::is_same_v<Tier, Int64Tier> ? 64 : 128;

Integer random_integer(std::mt19937_64& random, int bits) {
  Integer out = 0;
  for (int done = 0; done < bits; done += 32) {
    out <<= 32;
    out += static_cast<std::uint32_t>(random());
  }
  out %= Integer(1) << static_cast<unsigned>(bits);
  return random() % 2 == 0 ? out : Integer(-out);
}

template <class Tier>
Integer largest() {
  return (Integer(1) << static_cast<unsigned>(kWidth<Tier> - 1)) - 1;
}

template <class Tier>
typename Tier::Value narrow(const Integer& value) {
  typename Tier::Value out{};
  EXPECT_TRUE(Tier::load(value, out)) << value;
  EXPECT_EQ(Tier::to_integer(out), value);
  return out;
}

template <class Tier>
void check_fused(const Integer& a, const Integer& b, const Integer& c, const Integer& d,
                 const Integer& e) {
  const Integer numerator = a * b - c * d;
  ASSERT_EQ(numerator % e, 0);
  const Integer expected = numerator / e;
  typename Tier::Value out{};
  const bool fits = Tier::fused(narrow<Tier>(a), narrow<Tier>(b), narrow<Tier>(c),
                                narrow<Tier>(d), typename Tier::Divisor(narrow<Tier>(e)), out);
  ASSERT_EQ(fits, abs(expected) <= largest<Tier>())
      << a << ' ' << b << ' ' << c << ' ' << d << ' ' << e;
  if (fits) {
    ASSERT_EQ(Tier::to_integer(out), expected);
  }
}

template <class Tier>
class FixedWidth : public ::testing::Test {};
using Tiers = ::testing::Types<Int64Tier, Int128Tier>;
TYPED_TEST_SUITE(FixedWidth, Tiers);

TYPED_TEST(FixedWidth, LoadsExactlyWhatFits) {
  using Tier = TypeParam;
  const Integer top = largest<Tier>();
  typename Tier::Value out{};
  for (const Integer& value : {Integer(0), Integer(1), Integer(-1), top, Integer(-top)}) {
    EXPECT_TRUE(Tier::load(value, out));
    EXPECT_EQ(Tier::to_integer(out), value);
  }
  for (const Integer& value :
       {Integer(top + 1), Integer(-top - 1), Integer(top * 2 + 2), Integer(top * top)}) {
    EXPECT_FALSE(Tier::load(value, out));
  }
}

TYPED_TEST(FixedWidth, FusedAtTheEnds) {
  using Tier = TypeParam;
  const Integer top = largest<Tier>();
  const std::vector<Integer> values = {0, 1, -1, 2, -2, top, Integer(-top), Integer(top - 1)};
  for (const Integer& a : values) {
    for (const Integer& b : values) {
      for (const Integer& c : values) {
        for (const Integer& d : values) {
          for (const Integer& e : values) {
            if (e == 0 || (a * b - c * d) % e != 0) continue;
            check_fused<Tier>(a, b, c, d, e);
            ASSERT_FALSE(this->HasFatalFailure());
          }
        }
      }
    }
  }
}

TYPED_TEST(FixedWidth, FusedAtRandom) {
  using Tier = TypeParam;
  std::mt19937_64 random(5);
  const int width = kWidth<Tier> - 1;
  const auto size = [&](int limit) { return 1 + static_cast<int>(random() % unsigned(limit)); };
  for (int k = 0; k < 100000; ++k) {
    // e divides b and d, with every power of two.
    Integer e = random_integer(random, size(width / 2))
                << static_cast<unsigned>(size(width / 4));
    if (e == 0) e = 1;
    const Integer b = e * random_integer(random, size(width / 4));
    const Integer d = e * random_integer(random, size(width / 4));
    check_fused<Tier>(random_integer(random, size(width)), b,
                      random_integer(random, size(width)), d, e);
    ASSERT_FALSE(this->HasFatalFailure());
  }
}

TYPED_TEST(FixedWidth, ComparesProducts) {
  using Tier = TypeParam;
  std::mt19937_64 random(6);
  const int width = kWidth<Tier> - 1;
  for (int k = 0; k < 20000; ++k) {
    Integer v[4];
    for (Integer& value : v)
      value = random_integer(random, 1 + static_cast<int>(random() % unsigned(width)));
    if (k % 3 == 0) v[2] = v[1], v[3] = v[0] + static_cast<int>(random() % 3) - 1;
    if (abs(v[3]) > largest<Tier>()) continue;
    const int expected = Integer(v[0] * v[1]).compare(Integer(v[2] * v[3]));
    const int found = Tier::compare_products(narrow<Tier>(v[0]), narrow<Tier>(v[1]),
                                             narrow<Tier>(v[2]), narrow<Tier>(v[3]));
    ASSERT_EQ(found < 0, expected < 0);
    ASSERT_EQ(found > 0, expected > 0);
  }
}

TYPED_TEST(FixedWidth, MetersBits) {
  using Tier = TypeParam;
  typename Tier::BitMeter meter;
  EXPECT_EQ(meter.bits(), 0);
  meter.note(narrow<Tier>(Integer(-5)));
  EXPECT_EQ(meter.bits(), 3);
  meter.note(narrow<Tier>(Integer(8)));
  EXPECT_EQ(meter.bits(), 4);
  meter.note(narrow<Tier>(largest<Tier>()));
  EXPECT_EQ(meter.bits(), kWidth<Tier> - 1);
}

}  // namespace
}  // namespace stickslip::lp_detail
