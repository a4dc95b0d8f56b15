// SPDX-License-Identifier: GPL-3.0-or-later
// What was found on children is handed out in the order of a walk in preorder.
#include "engine/search/foresight.hpp"

#include <gtest/gtest.h>

namespace stickslip {
namespace {

using search_detail::Foresight;
using search_detail::SplitChoice;

/// Returns a result that is told by its twist.
LawForces::Found found(double number) {
  LawForces::Found result;
  result.twist = Reals::Constant(1, number);
  return result;
}

TEST(Foresight, ChildrenAreMetInPreorder) {
  Foresight foresight(1);
  const auto met = [&](std::size_t depth) {
    const auto known = foresight.enter(depth);
    return known ? known->twist[0] : 0;
  };
  EXPECT_EQ(met(0), 0);
  foresight.expect({found(1), std::nullopt, found(3)});
  EXPECT_EQ(met(1), 1);
  foresight.expect({found(4), found(5)});
  EXPECT_EQ(met(2), 4);
  EXPECT_EQ(met(3), 0);  // a child of which nothing was expected
  EXPECT_EQ(met(2), 5);
  EXPECT_EQ(met(1), 0);  // nothing was sought there
  EXPECT_EQ(met(1), 3);
  foresight.expect({found(6)});
  EXPECT_EQ(met(0), 0);  // another tree
  EXPECT_EQ(met(1), 0);
}

TEST(Foresight, SplitsThatServedComeFirst) {
  Foresight foresight(3);
  const SplitChoice opens{false, 1, 0};
  const SplitChoice slips{true, 1, 1};
  const SplitChoice other{false, 2, 2};
  foresight.learn(opens, false);
  foresight.learn(other, true);
  std::vector<SplitChoice> splits{opens, slips, other};
  foresight.sort(splits);
  EXPECT_EQ(splits[0].contact, 2U);
  EXPECT_TRUE(splits[1].is_slip);
  EXPECT_EQ(splits[2].order, 0U);
}

}  // namespace
}  // namespace stickslip
