// SPDX-License-Identifier: MIT
// The rows of FORMAT.md §1. What is asked, and what cannot be, is for tests/rules and
// tests/certificate/python.
#include "question.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace stickslip_check {
namespace {

TEST(Question, RowsOfAnyLength) {
  const Contact contact{{2, 5}, {3, 4}, Rational(1, 2), 7, 10};
  const Grasp grasp{{contact}, Wrench(3)};
  Options options;
  options.preload_direction = PreloadDirection{false, {15}};
  const Question question = pose(grasp, options, "grasp");
  const Row& row = question.box->row(0);
  ASSERT_TRUE(row.certain);
  // N = (3, 4, 2 * 4 - 5 * 3), T = (-4, 3, 2 * 3 + 5 * 4), v = (-7/25 N, 2, 3).
  EXPECT_EQ(row.v, (std::vector<Form>{{-21, -28, 49, 50, 75}}));
  EXPECT_EQ(row.tau, (std::vector<Form>{{-4, 3, 26, 0, 0}}));
  EXPECT_EQ(row.normals, (std::vector<Form>{{3, 4, -7}}));
  EXPECT_EQ(row.slips, (std::vector<std::vector<Form>>{{{-4, 3, 26}}}));
  EXPECT_EQ(row.scale, 1);
  EXPECT_EQ(row.edges[0], (std::vector<Form>{{10, 5, -40}}));  // 2 N - T
  EXPECT_EQ(row.edges[3], (std::vector<Form>{{2, 11, 12}}));
  EXPECT_EQ(row.weight, Rational(1, 50));
}

TEST(Question, RowsOfAnyLengthInSpace) {
  const Contact contact{{1, 2, 3}, {1, 2, 2}, Rational(1, 2), 9, 6};
  const Question question = pose({{contact}, Wrench(kSpatial)}, {}, "grasp");
  const Row& row = question.box->row(0);
  ASSERT_TRUE(row.certain);
  // N = (n, p x n); v = (-9/9 N, 6/3).
  EXPECT_EQ(row.v, (std::vector<Form>{{-1, -2, -2, 2, -1, 0, 2, 0}}));
  EXPECT_EQ(row.scale, Rational(1, 9));
  EXPECT_EQ(row.normals, (std::vector<Form>{{9, 18, 18, -18, 9, 0}}));
  // 9 S = 9 e_j - n_j n, with the moments of these.
  EXPECT_EQ(row.slips,
            (std::vector<std::vector<Form>>{
                {{8, -2, -2, 2, 26, -18}, {-2, 5, -4, -23, -2, 9}, {-2, -4, 5, 22, -11, 0}}}));
}

TEST(Question, MarginsKnowLengthsWithinAnInterval) {
  // 1/L = 1/sqrt(2) is between 11/16 and 12/16.
  Options options;
  options.preload_direction = PreloadDirection{false, {32}};
  const Contact contact{{0, 0, 0}, {1, 1, 0}, 0, 2, 16};
  Question question = pose({{contact}, Wrench(kSpatial)}, options, "grasp");
  EXPECT_TRUE(question.is_box);
  enlarge(question, 4);
  const Row& row = question.box->row(0);
  EXPECT_FALSE(row.certain);
  EXPECT_EQ(row.v,
            (std::vector<Form>{{-1, -1, 0, 0, 0, 0, 11, 22}, {-1, -1, 0, 0, 0, 0, 12, 24}}));
  const Box middle = question.box->middle();
  EXPECT_TRUE(middle.certain());
  EXPECT_EQ(middle.row(0).v, (std::vector<Form>{{-2, -2, 0, 0, 0, 0, 23, 46}}));
}

}  // namespace
}  // namespace stickslip_check
