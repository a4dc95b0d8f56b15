// SPDX-License-Identifier: MIT
#include "number.hpp"

#include <gtest/gtest.h>

namespace stickslip_check {
namespace {

Rational q(const char* text) {
  Rational value(text, 10);
  value.canonicalize();
  return value;
}

TEST(Number, RootsAreExactOrAbsent) {
  EXPECT_EQ(exact_sqrt(q("0")), q("0"));
  EXPECT_EQ(exact_sqrt(q("9/25")), q("3/5"));
  EXPECT_FALSE(exact_sqrt(q("2")));
  EXPECT_FALSE(exact_sqrt(q("1/2")));
  EXPECT_FALSE(exact_sqrt(q("8/2") + q("1/1000000000000000000000000000000")));
}

TEST(Number, RootsAreEnclosed) {
  EXPECT_EQ(root_bounds(q("9/25"), 64), Bounds(q("3/5")));
  EXPECT_EQ(root_bounds(q("0"), 64), Bounds(0));
  for (const char* text : {"2", "1/3", "200000000000000000000000000000000000001",
                           "5/1000000000000000000000000000000000000000000"}) {
    for (const unsigned bits : {64U, 65U, 128U}) {
      const Bounds root = root_bounds(q(text), bits);
      EXPECT_LT(root.low * root.low, q(text));
      EXPECT_GT(root.high * root.high, q(text));
      // low = j / 2^s and high = (j + 1) / 2^s, where j has so many bits.
      const Rational j = root.low / (root.high - root.low);
      EXPECT_EQ(j.get_den(), 1);
      EXPECT_EQ(mpz_sizeinbase(j.get_num_mpz_t(), 2), bits);
    }
  }
}

TEST(Number, PairwiseSumsAreSums) {
  for (int terms = 1; terms <= 40; ++terms) {
    PairwiseSum sum;
    Vector plain(2);
    for (int k = 1; k <= terms; ++k) {
      const Vector term{Rational(k, 2 * k + 1), Rational(-1, k)};
      sum.add(term);
      for (std::size_t j = 0; j < 2; ++j) plain[j] += term[j];
    }
    EXPECT_EQ(sum.total(), plain) << terms;
  }
}

TEST(Number, MessagesAreShortAndPlain) {
  EXPECT_EQ(quote("a\"b\n\x1b[31m\xff"), R"("a"b\x0a\x1b[31m\xff")");
  EXPECT_EQ(printable("\x7f\xc2\x9b ~"), R"(\x7f\xc2\x9b ~)");
  EXPECT_LT(quote(std::string(1000, 'x')).size(), 60U);
  EXPECT_LT(show(Vector(1000, Rational(1, 3))).size(), 80U);
  EXPECT_LT(show(Rational(std::string(1000, '7'))).size(), 80U);
}

}  // namespace
}  // namespace stickslip_check
