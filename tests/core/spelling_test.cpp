// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

TEST(DidYouMean, NamesTheNearestOfThoseThatAreNear) {
  const std::vector<std::string> known{"decide", "states", "--node-limit", "--u"};
  EXPECT_EQ(did_you_mean("decides", known), "did you mean \"decide\"? ");
  EXPECT_EQ(did_you_mean("dcide", known), "did you mean \"decide\"? ");
  EXPECT_EQ(did_you_mean("stade", known), "did you mean \"states\"? ");
  EXPECT_EQ(did_you_mean("--nodelimit", known), "did you mean \"--node-limit\"? ");
  EXPECT_EQ(did_you_mean("-node-limit", known), "did you mean \"--node-limit\"? ");
  EXPECT_EQ(did_you_mean("dec", known), "did you mean \"decide\"? ");  // half of it
  EXPECT_EQ(did_you_mean("de", known), "");
  EXPECT_EQ(did_you_mean("--x", known), "");  // dashes are nothing to go by
  EXPECT_EQ(did_you_mean("", known), "");
  EXPECT_EQ(did_you_mean("decide", {}), "");
  EXPECT_EQ(did_you_mean(std::string(100000, 'x'), {std::string(100000, 'x')}), "");
}

TEST(ChoiceOf, ListsAll) {
  EXPECT_EQ(choice_of("tow", {"one", "two"}, "there are "), "there are one, two");
  EXPECT_EQ(choice_of("twoo", {"one", "two"}, "there are "),
            "did you mean \"two\"? there are one, two");
}

}  // namespace
}  // namespace stickslip
