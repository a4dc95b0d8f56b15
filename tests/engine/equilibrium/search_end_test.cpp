// SPDX-License-Identifier: GPL-3.0-or-later
// Which reason is given where several are true: the one that whoever asks can do most about.
#include "engine/equilibrium/search_end.hpp"

#include <gtest/gtest.h>

namespace stickslip {
namespace search_end_test {

SearchReport ended(SearchEnd end) {
  SearchReport report;
  report.end = end;
  report.node_limit = 77;
  return report;
}

TEST(SearchEnd, EachEndHasAReason) {
  EXPECT_EQ(undecided_by(ended(SearchEnd::kNodes)).reason, "nodes");
  EXPECT_EQ(undecided_by(ended(SearchEnd::kDepth)).reason, "depth");
  EXPECT_EQ(undecided_by(ended(SearchEnd::kTwist)).reason, "twist");
  EXPECT_EQ(undecided_by(ended(SearchEnd::kPoints)).reason, "corners");
  EXPECT_EQ(undecided_by(ended(SearchEnd::kPlane)).reason, "plane");
  EXPECT_EQ(undecided_by(ended(SearchEnd::kCandidate)).reason, "plane");
  EXPECT_EQ(limit_reached(77).reason, "nodes");
}

// Each truth that is added goes before those that came before.
TEST(SearchEnd, ReasonsGoBeforeOthers) {
  SearchReport report = ended(SearchEnd::kDepth);
  report.near = {1, 2};
  EXPECT_EQ(undecided_by(report).reason, "degree");
  EXPECT_EQ(undecided_by(report).near, report.near);
  report.is_free = true;
  EXPECT_EQ(undecided_by(report).reason, "free");
  report.is_wide = true;
  EXPECT_EQ(undecided_by(report).reason, "box");
  report.end = SearchEnd::kNodes;
  EXPECT_EQ(undecided_by(report).reason, "nodes");
  EXPECT_NE(undecided_by(report).limit.find("a tree reached the limit of 77 nodes"),
            std::string::npos);
  report.is_spent = true;
  EXPECT_EQ(undecided_by(report).limit.find("all trees together"), 0U);
  report.is_far = true;
  EXPECT_EQ(undecided_by(report).reason, "far");
}

// Only of many grasps is it said that no two of them differ.
TEST(SearchEnd, OfABoxNoTwoGraspsWereFound) {
  for (const bool is_wide : {false, true}) {
    SearchReport report = ended(SearchEnd::kNodes);
    report.is_wide = is_wide;
    const bool says = undecided_by(report).limit.find("no two grasps") != std::string::npos;
    EXPECT_EQ(says, is_wide);
  }
}

}  // namespace search_end_test
}  // namespace stickslip
