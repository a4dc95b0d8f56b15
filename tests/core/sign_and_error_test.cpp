// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "stickslip/core/error.hpp"
#include "stickslip/core/ids.hpp"
#include "stickslip/core/sign.hpp"

namespace stickslip {
namespace {

constexpr Sign kSigns[] = {Sign::kNegative, Sign::kZero, Sign::kPositive};

TEST(Sign, OfNumbers) {
  EXPECT_EQ(sign_of(Rational(-1, 1000000)), Sign::kNegative);
  EXPECT_EQ(sign_of(Rational(0)), Sign::kZero);
  EXPECT_EQ(sign_of(parse_rational("1e-4096")), Sign::kPositive);
  EXPECT_EQ(sign_of(Integer("-99999999999999999999")), Sign::kNegative);
  EXPECT_EQ(sign_of_int(-7), Sign::kNegative);
}

TEST(Sign, MultipliesAndNegatesLikeItsNumbers) {
  for (const Sign a : kSigns) {
    EXPECT_EQ(to_int(-a), -to_int(a));
    for (const Sign b : kSigns) EXPECT_EQ(to_int(a * b), to_int(a) * to_int(b));
  }
}

TEST(Sign, Prints) {
  EXPECT_EQ(to_char(Sign::kNegative), '-');
  EXPECT_EQ(to_char(Sign::kZero), '0');
  EXPECT_EQ(to_char(Sign::kPositive), '+');
}

TEST(Id, OrdersByIndex) {
  EXPECT_EQ(ContactId(3).index(), 3U);
  EXPECT_EQ(ContactId(3), ContactId(3));
  EXPECT_NE(ContactId(3), ContactId(4));
  EXPECT_LT(ContactId(3), ContactId(4));
  static_assert(!std::is_convertible_v<int, ContactId>);
  static_assert(!std::is_convertible_v<ContactId, CircleId>);
}

TEST(InputError, JoinsItsPartsAndKeepsThem) {
  const InputError error("a.json", "wrench", "found null", "expected an array");
  EXPECT_STREQ(error.what(), "a.json: wrench: found null; expected an array");
  EXPECT_EQ(error.file(), "a.json");
  EXPECT_EQ(error.place(), "wrench");
  EXPECT_EQ(error.problem(), "found null");
  EXPECT_EQ(error.remedy(), "expected an array");
  EXPECT_STREQ(error.in_file("b.json").what(), "b.json: wrench: found null; expected an array");
}

TEST(InputError, LeavesOutWhatIsEmpty) {
  EXPECT_STREQ(InputError("", "wrench", "bad", "").what(), "wrench: bad");
  EXPECT_STREQ(InputError("", "", "bad", "do better").what(), "bad; do better");
  EXPECT_STREQ(InputError("", "", "bad", "").in_file("f").what(), "f: bad");
}

TEST(Require, ThrowsInEveryBuildType) {
  EXPECT_NO_THROW(require(true, "fine"));
  EXPECT_THROW(require(false, "broken"), ContractError);
}

TEST(Quote, EscapesAndCuts) {
  EXPECT_EQ(quote("abc"), "\"abc\"");
  EXPECT_EQ(quote(""), "\"\"");
  EXPECT_EQ(quote("a\nb\x1b"), "\"a\\x0ab\\x1b\"");
  EXPECT_EQ(quote(std::string(40, 'x')), "\"" + std::string(40, 'x') + "\"");
  EXPECT_EQ(quote(std::string(41, 'x')), "\"" + std::string(40, 'x') + "...\"");
  // 39 letters and a two-byte letter, which is kept whole or not at all.
  EXPECT_EQ(quote(std::string(39, 'x') + "\xc3\xa9z"), "\"" + std::string(39, 'x') + "...\"");
}

}  // namespace
}  // namespace stickslip
