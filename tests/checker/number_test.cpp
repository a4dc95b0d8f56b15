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

TEST(Number, DecimalsMeanWhatTheySpell) {
  const std::pair<const char*, const char*> cases[] = {
      {"0", "0"},        {"-0", "0"},          {"+3", "3"},      {"010", "10"},
      {"-0.25", "-1/4"}, {"1e-3", "1/1000"},   {"1E+2", "100"},  {"12.50e1", "125"},
      {"3/5", "3/5"},    {"-6/4", "-3/2"},     {"+6/04", "3/2"}, {"0e4096", "0"},
      {"0.1", "1/10"},   {"-1.5e-1", "-3/20"}, {"2e0", "2"},     {"1e-0003", "1/1000"},
  };
  for (const auto& [text, value] : cases) {
    const std::optional<Rational> read = parse_decimal(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(*read, q(value)) << text;
  }
  EXPECT_TRUE(parse_decimal("1e4096"));
  EXPECT_TRUE(parse_decimal(std::string(16384, '7')));
}

TEST(Number, WhatIsNoDecimal) {
  for (const char* text : {"",         "-",    "+",      ".5",      "5.",
                           "1e",       "1e+",  "e3",     "1/0",     "1/-2",
                           "1/",       "/2",   "1.5/2",  "1/2.5",   "1/2e3",
                           " 1",       "1 ",   "0x10",   "nan",     "inf",
                           "Infinity", "--1",  "1e4097", "1e-4097", "1e99999999999999999999",
                           "1,5",      "1_000"}) {
    EXPECT_FALSE(parse_decimal(text)) << text;
  }
  EXPECT_FALSE(parse_decimal(std::string(16385, '7')));
  EXPECT_FALSE(parse_decimal(std::string("1\0", 2)));
}

TEST(Number, FractionsOfCertificates) {
  EXPECT_EQ(parse_fraction("-6/4"), q("-3/2"));
  EXPECT_EQ(parse_fraction("007"), q("7"));
  EXPECT_EQ(parse_fraction("-0/3"), q("0"));
  EXPECT_TRUE(parse_fraction(std::string(65536, '7')));
  EXPECT_FALSE(parse_fraction(std::string(65537, '7')));
  for (const char* text :
       {"", "-", "+1", "1.0", "1e2", "1/0", "1/-2", "1/", "/2", " 1", "1/2/3"}) {
    EXPECT_FALSE(parse_fraction(text)) << text;
  }
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
