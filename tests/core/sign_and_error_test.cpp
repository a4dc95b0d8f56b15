// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "stickslip/core/error.hpp"
#include "stickslip/core/sign.hpp"

namespace stickslip {
namespace {

TEST(Sign, Prints) {
  EXPECT_EQ(to_char(Sign::kNegative), '-');
  EXPECT_EQ(to_char(Sign::kZero), '0');
  EXPECT_EQ(to_char(Sign::kPositive), '+');
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
