// SPDX-License-Identifier: GPL-3.0-or-later
// Spans of wrenches, and the motions that none of them sees, by what defines them.
#include "stickslip/engine/force_span.hpp"

#include <gtest/gtest.h>

#include "law_cases.hpp"
#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip {
namespace force_span_test {

using test::RandomSource;

std::vector<RationalRow> random_wrenches(RandomSource& random, std::size_t motions) {
  std::vector<RationalRow> wrenches;
  for (int k = random.between(0, static_cast<int>(motions) + 1); k > 0; --k) {
    RationalRow& wrench = wrenches.emplace_back();
    while (wrench.size() < motions) wrench.emplace_back(random.between(-1, 1));
  }
  return wrenches;
}

TEST(ForceSpan, RowsSpanWhatFreeMotionsDoNotSee) {
  RandomSource random(241);
  for (int round = 0; round < 200; ++round) {
    const std::size_t motions = round % 2 == 0 ? 3 : 6;
    const std::vector<RationalRow> wrenches = random_wrenches(random, motions);
    const ForceSpan span(motions, wrenches);
    EXPECT_EQ(span.rank(), wrenches.empty() ? 0 : rank_of(wrenches));
    ASSERT_EQ(span.rows().size(), span.columns().size());
    for (std::size_t p = 0; p < span.rank(); ++p) {
      for (std::size_t q = 0; q < span.rank(); ++q) {
        EXPECT_EQ(span.rows()[p][span.columns()[q]], p == q ? 1 : 0);
      }
    }
    const std::vector<RationalRow> free = span.free_motions();
    EXPECT_EQ(free.size() + span.rank(), motions);
    if (!free.empty()) {
      EXPECT_EQ(rank_of(free), free.size());
    }
    for (const RationalRow& z : free) {
      for (const RationalRow& wrench : wrenches) EXPECT_TRUE(dot(z, wrench).is_zero());
      for (const RationalRow& row : span.rows()) EXPECT_TRUE(dot(z, row).is_zero());
    }
  }
}

// Forces of contacts are N and, where there is friction, S at every corner.
TEST(ForceSpan, OfALawSpansItsRowsAtAllCorners) {
  RandomSource random(242);
  for (int round = 0; round < 60; ++round) {
    GraspBox box = test::random_law_box(random, round % 2 == 1);
    box.contacts.resize(1);
    const bool rubs = random.one_in(2);
    if (!rubs) box.contacts.front().friction = {};
    const GraspLaw law(box, NormalLaw::kUnilateral);
    std::vector<RationalRow> rows;
    for (const CornerRow& corner : law.contacts.front().corners) {
      rows.push_back(corner.normal);
      for (const Row& slip : corner.slip) {
        if (rubs) rows.emplace_back(slip.begin(), slip.end());
      }
    }
    const ForceSpan span(law);
    EXPECT_EQ(span.rank(), rank_of(rows));
    // A load is seen by no free motion, or else unopposed.
    bool is_opposed = true;
    for (const RationalRow& z : span.free_motions()) {
      for (std::size_t j = 0; j < z.size(); ++j) {
        is_opposed = is_opposed && (z[j].is_zero() || law.wrench[j].is_point());
      }
      RationalRow low;
      for (const Interval& component : law.wrench) low.push_back(component.low);
      is_opposed = is_opposed && dot(z, low).is_zero();
    }
    EXPECT_EQ(span.has_loads_of(law), is_opposed);
  }
}

// The part that is taken from a load is across all that remain, where torques are divided by a
// length: no load without work on free motions is nearer.
TEST(ForceSpan, TheOpposedPartIsTheNearestLoad) {
  RandomSource random(243);
  int moved = 0;
  for (int round = 0; round < 100; ++round) {
    Law law;
    const ForceSpan span(3, random_wrenches(random, 3));
    const RationalRow load = test::random_row(random, 3);
    const Rational length(random.between(1, 4), 2);
    const RationalRow opposed = opposed_part(span, law, load, length);
    for (const RationalRow& z : span.free_motions()) EXPECT_TRUE(dot(z, opposed).is_zero());
    const RationalRow off{load[0] - opposed[0], load[1] - opposed[1],
                          (load[2] - opposed[2]) / (length * length)};
    for (const RationalRow& row : span.rows()) EXPECT_TRUE(dot(off, row).is_zero());
    moved += opposed == load ? 0 : 1;
  }
  EXPECT_GE(moved, 30);
}

}  // namespace force_span_test
}  // namespace stickslip
