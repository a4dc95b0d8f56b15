// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/root_sum.hpp"

#include <gtest/gtest.h>

#include "random_numbers.hpp"

namespace stickslip {
namespace {

using testing::Random;

/// a sqrt(p).
struct Root {
  Rational factor;
  Rational radicand;

  int sign() const { return radicand.is_zero() ? 0 : factor.sign(); }
  Rational square() const { return factor * factor * radicand; }
};

// The naive twin: signs by squaring.
int sign_by_squares(const Root& a, const Root& b) {
  if (a.sign() * b.sign() >= 0) return a.sign() != 0 ? a.sign() : b.sign();
  return a.square() == b.square() ? 0 : a.square() > b.square() ? a.sign() : b.sign();
}

int sign_by_squares(const Root& a, const Root& b, const Root& c) {
  const int ab = sign_by_squares(a, b);
  if (ab * c.sign() >= 0) return ab != 0 ? ab : c.sign();
  // (a + b)^2 - c^2.
  const int larger = sign_by_squares(Root{a.square() + b.square() - c.square(), 1},
                                     Root{2 * a.factor * b.factor, a.radicand * b.radicand});
  return larger == 0 ? 0 : larger > 0 ? ab : c.sign();
}

RootSum sum_of(const Root& a, const Root& b, const Root& c) {
  return RootSum::root(a.factor, a.radicand) + RootSum::root(b.factor, b.radicand) +
         RootSum::root(c.factor, c.radicand);
}

void expect_agrees(const Root& a, const Root& b, const Root& c) {
  const RootSum sum = sum_of(a, b, c);
  const int sign = sign_by_squares(a, b, c);
  ASSERT_EQ(sum.sign(), sign) << a.factor << " " << a.radicand << ", " << b.factor << " "
                              << b.radicand << ", " << c.factor << " " << c.radicand;
  ASSERT_EQ(sum == RootSum(), sign == 0);
  ASSERT_EQ(sum < RootSum(), sign < 0);
  ASSERT_EQ(magnitude(sum).sign(), sign == 0 ? 0 : 1);
  const auto [low, high] = sum.between(100);
  ASSERT_LE((RootSum(low) - sum).sign(), 0);
  ASSERT_LE((sum - RootSum(high)).sign(), 0);
}

TEST(RootSum, SmallWorldAgainstSquares) {
  const Rational radicands[] = {0, 1, 2, 3, 4, 8, Rational(1, 2), Rational(9, 2), 12};
  std::size_t zeros = 0;
  for (const Rational& p : radicands) {
    for (const Rational& q : radicands) {
      for (int a = -3; a <= 3; ++a) {
        for (int b = -3; b <= 3; ++b) {
          for (int c = -3; c <= 3; ++c) {
            expect_agrees({a, p}, {b, q}, {c, 2});
            if (HasFatalFailure()) return;
            if (sum_of({a, p}, {b, q}, {c, 2}) == RootSum()) ++zeros;
          }
        }
      }
    }
  }
  EXPECT_GT(zeros, 500U);
}

TEST(RootSum, RandomNumbersAgainstSquares) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const auto root = [&] { return Root{random.big(30), abs(random.big(30))}; };
    const Root a = root();
    const Root b = root();
    expect_agrees(a, b, root());
    // Next to 0: c is a + b to many digits.
    const auto near =
        (RootSum::root(a.factor, a.radicand) + RootSum::root(b.factor, b.radicand))
            .between(400)
            .first;
    expect_agrees(a, b, {-near, 1});
    // And 0 itself, in disguise.
    expect_agrees(a, {-a.factor / 7, 49 * a.radicand}, {0, 1});
    if (HasFatalFailure()) return;
  }
}

TEST(RootSum, DifferencesThatNoDoubleSees) {
  const Rational large = parse_rational("1e60");
  const RootSum difference = RootSum::root(1, large * large + 1) - RootSum(large);
  EXPECT_EQ(difference.sign(), 1);
  EXPECT_TRUE(difference < RootSum(1 / large));
  EXPECT_EQ(to_readable_string(difference), "~5e-61");
  EXPECT_TRUE(RootSum::root(1, 50) - RootSum::root(2, 2) - RootSum::root(1, 18) == RootSum());
}

TEST(RootSum, KnowsWhatIsRational) {
  EXPECT_EQ(RootSum().rational(), Rational(0));
  EXPECT_EQ(RootSum::root(3, 4).rational(), Rational(6));
  EXPECT_EQ(RootSum::root(3, 2).rational(), std::nullopt);
  EXPECT_EQ(RootSum::root(3, 2).rational_square(), Rational(18));
  EXPECT_EQ((RootSum::root(3, 2) + RootSum(1)).rational_square(), std::nullopt);
  EXPECT_EQ((RootSum::root(3, 2) + RootSum(1) - RootSum::root(1, 18)).rational(), Rational(1));
}

TEST(RootSum, IsSpelledLikeANumber) {
  EXPECT_EQ(to_readable_string(RootSum(Rational(-1, 3))), to_readable_string(Rational(-1, 3)));
  EXPECT_EQ(to_readable_string(RootSum::root(-1, 2)), to_readable_string(-1, 2));
  const RootSum value = RootSum::root(1, 3) - RootSum::root(1, 2);  // 0.31783724519578...
  EXPECT_EQ(to_readable_string(value), "~0.317837");
  EXPECT_EQ(to_readable_string(-value), "~-0.317837");
  EXPECT_EQ(enclose(value, 5).lower, "0.31783");
  EXPECT_EQ(enclose(value, 5).upper, "0.31784");
  EXPECT_EQ(enclose(-value, 5).lower, "-0.31784");
  EXPECT_EQ(enclose(RootSum(), 5).upper, "0");
  EXPECT_EQ(enclose(RootSum(Rational(1, 4))).lower, "0.25");
  // 1/2 and next to nothing is no number of few digits.
  const RootSum near_half = RootSum(Rational(1, 2)) +
                            RootSum::root(parse_rational("1e-40"), 2) -
                            RootSum::root(parse_rational("1e-41"), 3);
  EXPECT_EQ(to_readable_string(near_half), "~0.5");
}

}  // namespace
}  // namespace stickslip
