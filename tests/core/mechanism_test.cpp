// SPDX-License-Identifier: GPL-3.0-or-later
// Several bodies: how links move, and that what is written is read again. What files may not
// say is in refused.txt of the corpus.
#include "stickslip/core/mechanism.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "stickslip/core/grasp_file.hpp"

namespace stickslip {
namespace {

std::string file(const std::string& bodies, const std::string& rest) {
  return R"({"format": "stickslip-grasp/3", "bodies": [)" + bodies + "], " + rest + "}";
}

const char kArm[] =
    R"({"name": "box"}, {"name": "a", "hinge": [1, 2]}, {"name": "b", "on": "a", "slide": [3, 4]})";
const char kJoints[] =
    R"("joints": [{"turns": {"a": 2, "b": "1/2"}, "stiffness": 3}, {"name": "s", "turns": {"b": 1}}])";
const char kFoot[] = R"({"of": "box", "position": [0, 0], "normal": [0, 1], "friction": 1})";

GraspBox box_in(const std::string& text) {
  return *parse_any_grasp(text, "f").content.box();
}

TEST(Mechanism, LinksMoveAsWhatTheyAreOnAndAsTheirJointsTurn) {
  const GraspBox box = box_in(file(kArm, std::string(kJoints) + R"(, "contacts": [])"));
  const Mechanism& m = *box.mechanism;
  ASSERT_EQ(m.coordinates(), 5U);
  // (2, 3) is 1 right of the hinge and 1 above: a unit of the first joint turns it by 2.
  const auto moved = [&](std::size_t body, const RationalRow& z) {
    const std::vector<RationalRow> j = m.motion_of(body);
    const auto dot = [](const RationalRow& a, const RationalRow& b) {
      return stickslip::dot(a, b);
    };
    const Rational turn = dot(j[2], z);
    return RationalRow{dot(j[0], z) - 3 * turn, dot(j[1], z) + 2 * turn, turn};
  };
  EXPECT_EQ(moved(0, {1, 2, 3, 9, 9}), (RationalRow{1 - 9, 2 + 6, 3}));
  EXPECT_EQ(moved(1, {7, 7, 7, 1, 0}), (RationalRow{-2, 2, 2}));
  EXPECT_EQ(moved(2, {7, 7, 7, 1, 0}), (RationalRow{-2 + Rational(3, 2), 2 + 2, 2}));
  EXPECT_EQ(moved(2, {7, 7, 7, 0, 1}), (RationalRow{3, 4, 0}));
  EXPECT_EQ(m.motion_of({})[0], RationalRow(5));
  EXPECT_EQ(m.row_of({{1, 10}, {2, 1}}), (RationalRow{0, 0, 0, 20 + Rational(1, 2), 1}));
  EXPECT_EQ(coordinate_names(m),
            (std::vector<std::string>{"box.x", "box.y", "box.turn", "joint 0", "s"}));
  EXPECT_EQ(box.springs.size(), 1U);
}

TEST(Mechanism, AHingeInSpaceTurnsAboutItsAxis) {
  const GraspBox box = box_in(file(
      R"({"name": "a", "hinge": {"at": [1, 2, 3], "axis": [0, 0, 2]}})",
      R"("joints": [{"turns": {"a": 1}}], "contacts": [{"of": "a", "position": [2, 2, 9], "normal": [0, 1, 0], "friction": 0}])"));
  const std::vector<RationalRow> j = box.mechanism->motion_of(0);
  RationalRow twist;
  for (const RationalRow& row : j) twist.push_back(row.front());
  // 1 away from the axis in x: it moves by 2 along y.
  EXPECT_EQ(twist[0] - twist[5] * 2, 0);
  EXPECT_EQ(twist[1] + twist[5] * 2, 2);
  EXPECT_TRUE(twist[2].is_zero());
}

TEST(Mechanism, WhatIsWrittenIsReadAgain) {
  const std::string text = file(
      kArm,
      std::string(kJoints) +
          R"(, "name": "arm", "tendons": [{"name": "t", "over": {"a": 1, "b": -1}, "stiffness": {"min": 1, "max": 2}, "tension": -3}],
          "ratchets": [{"over": {"b": 2}, "stiffness": 5, "preload": "1/3"}],
          "contacts": [)" +
          kFoot +
          R"(, {"of": "box", "by": "b", "position": [{"min": 0, "max": 1}, 2], "normal": [3, 4], "friction": "1/2", "preload": 1}],
          "loads": [{"body": "b", "force": [1, 2], "at": [3, 4]}, {"body": "box", "wrench": [{"min": 0, "max": 1}, 0, 0]}],
          "cases": [{"name": "c", "loads": [{"body": "a", "torque": 1}]}])");
  const GraspFile once = parse_any_grasp(text, "f");
  const std::string written = write_grasp_file(once);
  const GraspFile again = parse_any_grasp(written, "written");
  EXPECT_EQ(write_grasp_file(again), written);
  const auto& a = *once.content.box();
  const auto& b = *again.content.box();
  EXPECT_EQ(a.wrench, b.wrench);
  EXPECT_EQ(once.cases.front().wrench, again.cases.front().wrench);
  ASSERT_EQ(a.springs.size(), 3U);
  for (std::size_t k = 0; k < a.springs.size(); ++k) {
    EXPECT_EQ(a.springs[k].row, b.springs[k].row);
    EXPECT_EQ(a.springs[k].stiffness, b.springs[k].stiffness);
    EXPECT_EQ(a.springs[k].force, b.springs[k].force);
    EXPECT_EQ(a.springs[k].kind, b.springs[k].kind);
  }
  ASSERT_EQ(b.contacts.size(), 2U);
  EXPECT_EQ(b.contacts[1].by, BodyIndex(2));
  EXPECT_EQ(a.mechanism->motion_between(0, 2), b.mechanism->motion_between(0, 2));
}

}  // namespace
}  // namespace stickslip
