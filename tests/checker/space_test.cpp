// SPDX-License-Identifier: MIT
// Grasps in space (FORMAT.md §7): rows, and what no choice of generators may change. Rules
// and places are for tests/rules.
#include <gtest/gtest.h>

#include "leaf.hpp"
#include "support.hpp"

namespace stickslip_check {
namespace {

TEST(Space, RowsOfAnyLength) {
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

TEST(Space, MarginsKnowLengthsWithinAnInterval) {
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

TEST(Space, TheFirstContactThatDiffersIsNamed) {
  const std::string text = R"({"format": "stickslip-grasp/2", "contacts": [
    {"position": [0, 0, 0], "normal": [0, 0, 1], "friction": 1},
    {"position": [0, 0], "normal": [0, 1], "friction": 1}],
    "wrench": [0, 0, 0, 0, 0, 0]})";
  const auto expect = [](const std::string& grasp, const char* place, const char* problem) {
    try {
      read(grasp);
      FAIL();
    } catch (const Malformed& error) {
      EXPECT_EQ(error.place, place);
      EXPECT_EQ(error.problem, problem);
    }
  };
  expect(text, "line 3, contacts[1].position",
         "found an array of 2, expected 3 coordinates [x, y, z], as the first contact has");
  expect(replaced(text, "[0, 0, 0]", "[0, 0]"), "line 2, contacts[0].normal",
         "found an array of 3, expected 2 coordinates [x, y]");
}

Box random_box(Random& random) {
  Grasp grasp{{}, Wrench(kSpatial)};
  constexpr int kNormals[][3] = {{1, 0, 0}, {0, 0, -1}, {0, 2, 0}, {1, 2, 2}, {-2, 1, 2}};
  for (int m = between(random, 1, 2); m > 0; --m) {
    const int* n = kNormals[between(random, 0, 4)];
    Contact contact;
    for (int j = 0; j < 3; ++j) {
      contact.position.emplace_back(Rational(between(random, -1, 1)));
      contact.normal.emplace_back(n[j]);
    }
    contact.friction = Rational(between(random, 0, 2), 2);
    contact.stiffness = 1;
    contact.preload = between(random, 0, 1);
    grasp.contacts.push_back(std::move(contact));
  }
  for (Bounds& w : grasp.wrench) w = between(random, -3, 3);
  Box box = *pose(grasp, {}, "").box;
  for (std::size_t i = 0; i < box.size(); ++i) {
    for (const Parameter name : {Parameter::kX, Parameter::kZ, Parameter::kFriction,
                                 Parameter::kPreload, Parameter::kStiffness}) {
      if (between(random, 0, 3) > 0) continue;
      const Rational low = box.contact(i)[name].low;
      box = box.with(name, i, Bounds(low, low + Rational(1, 8)));
    }
  }
  return box;
}

TEST(Space, RedundantRaysChangeNoLeaf) {
  Random random(577);
  std::size_t tally[2]{};
  for (int trial = 0; trial < 1500; ++trial) {
    const Box box = random_box(random);
    Cone cone(kSpatial + 2);
    Strict strict;
    insert(strict.conditions, 0);
    cone = cone.cut({0, 0, 0, 0, 0, 0, 1, 0}).cut({0, 0, 0, 0, 0, 0, 0, 1}, true);
    for (int cuts = between(random, 0, 6); cuts > 0; --cuts) {
      const std::size_t i = static_cast<std::size_t>(between(random, 0, 5));
      if (i < box.size() && box.row(i).slips.size() == 1) {
        strict.slips.push_back(i);
        continue;
      }
      Form a(kSpatial + 1);
      for (Integer& c : a) c = between(random, 0, 2) == 0 ? between(random, -1, 1) : 0;
      if (between(random, 0, 1) == 0) insert(strict.conditions, cone.cuts());
      cone = cone.cut(a);
    }
    const Redundant more(random, cone);
    const Generators extreme(box, cone, strict);
    const Generators redundant(box, more, strict);
    EXPECT_EQ(extreme.barred(), redundant.barred());
    if (extreme.barred()) continue;
    for (int leaves = 0; leaves < 4; ++leaves) {
      Vector y;
      for (const Bounds& w : box.wrench) {
        y.push_back(leaves == 0 ? Rational(-w.low) : Rational(between(random, -1, 1)));
      }
      const bool holds = !leaf_refusal(box, extreme, y);
      ++tally[holds ? 1 : 0];
      EXPECT_EQ(!leaf_refusal(box, redundant, y), holds) << "trial " << trial;
    }
  }
  EXPECT_GT(tally[0], 500U);
  EXPECT_GT(tally[1], 100U);
}

}  // namespace
}  // namespace stickslip_check
