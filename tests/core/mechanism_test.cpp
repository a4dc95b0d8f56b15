// SPDX-License-Identifier: GPL-3.0-or-later
// Several bodies: how links move, what files may not say, and that what is written is read
// again.
#include "stickslip/core/mechanism.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip {
namespace {

using ::testing::HasSubstr;

std::string file(const std::string& bodies, const std::string& rest) {
  return R"({"format": "stickslip-grasp/3", "bodies": [)" + bodies + "], " + rest + "}";
}

const char kArm[] =
    R"({"name": "box"}, {"name": "a", "hinge": [1, 2]}, {"name": "b", "on": "a", "slide": [3, 4]})";
const char kJoints[] =
    R"("joints": [{"turns": {"a": 2, "b": "1/2"}, "stiffness": 3}, {"name": "s", "turns": {"b": 1}}])";
const char kFoot[] = R"({"of": "box", "position": [0, 0], "normal": [0, 1], "friction": 1})";

GraspBox box_in(const std::string& text) {
  return std::get<GraspBox>(parse_any_grasp(text, "f").content);
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

TEST(Mechanism, WhatAFileMayNotSay) {
  const std::string contacts = R"("contacts": [)" + std::string(kFoot) + "]";
  struct Bad {
    std::string text;
    std::string place;
    std::string words;
  };
  const auto contact = [&](const std::string& bodies) {
    return file(kArm, std::string(kJoints) + R"(, "contacts": [{)" + bodies +
                          R"("position": [0, 0], "normal": [0, 1], "friction": 1}])");
  };
  const auto load = [&](const std::string& text) {
    return file(kArm, std::string(kJoints) + ", " + contacts + R"(, "loads": [)" + text + "]");
  };
  const auto arm = [&](const std::string& more) {
    return file(kArm, std::string(kJoints) + ", " + contacts + ", " + more);
  };
  const Bad all[] = {
      {file("", contacts), "bodies", "empty"},
      {file(R"({"name": "ground"})", contacts), "bodies[0].name", "ground"},
      {file(R"({"name": ""})", contacts), "bodies[0].name", "empty"},
      {file(R"({"name": "box"}, {"name": "box"})", contacts), "bodies[1].name", "twice"},
      {file(R"({"name": "box"}, {"name": "a", "hinge": [0, 0], "slide": [0, 1]})", contacts),
       "bodies[1]", "both"},
      {file(R"({"name": "box"}, {"name": "a", "on": "box"})", contacts), "bodies[1].on",
       "hinge"},
      {file(R"({"name": "box"}, {"name": "a", "slide": [0, 0]})", contacts), "bodies[1].slide",
       "0"},
      // A loop can only be written by a link that names one behind it.
      {file(
           R"({"name": "box"}, {"name": "a", "hinge": [0, 0], "on": "b"}, {"name": "b", "hinge": [0, 0], "on": "a"})",
           contacts),
       "bodies[1].on", "no body"},
      {file(R"({"name": "box"}, {"name": "a", "hinge": [0, 0]})", contacts), "bodies[1]",
       "no joint"},
      {arm(R"("joints": [{"turns": {}}])"), "1:", "twice"},
      {file(kArm, R"("joints": [{"turns": {}}], )" + contacts), "joints[0].turns", "no link"},
      {file(kArm, R"("joints": [{"turns": {"box": 1}}], )" + contacts), "joints[0].turns",
       "is no link"},
      {file(kArm, R"("joints": [{"turns": {"c": 1}}], )" + contacts), "joints[0].turns",
       "no body"},
      {file(kArm, R"("joints": [{"turns": {"a": 0, "b": 1}}], )" + contacts),
       "joints[0].turns.a", "0"},
      {arm(R"("tendons": [{"over": {"b": 1}, "stiffness": -1}])"), "tendons[0].stiffness",
       "-1"},
      {arm(R"("tendons": [{"over": {"a": 1}, "tension": {"min": 1, "max": 0}}])"),
       "tendons[0].tension", "empty"},
      {arm(R"("ratchets": [{"over": {"a": 1}}])"), "ratchets[0]", "stiffness"},
      {arm(R"("ratchets": [{"over": {"a": 1}, "stiffness": 0}])"), "ratchets[0].stiffness",
       "0"},
      {arm(R"("ratchets": [{"over": {"a": 1}, "stiffness": 1, "preload": -1}])"),
       "ratchets[0].preload", "-1"},
      {arm(R"("outline": [[0, 0], [1, 0], [0, 1]])"), "", "outline"},
      {contact(""), "contacts[0]", "of"},
      {contact(R"("of": "box", "by": "box", )"), "contacts[0]", "itself"},
      {contact(R"("of": "c", )"), "contacts[0].of", "no body"},
      {contact(R"("of": "box", "by": "c", )"), "contacts[0].by", "no body"},
      {load(R"({"weight": 1, "at": [0, 0]})"), "loads[0]", "body"},
      {load(R"({"body": "a", "wrench": [0, 0, 1]})"), "loads[0].wrench", "is a link"},
      {load(R"({"body": "box", "wrench": [0, 1]})"), "loads[0].wrench", "2"},
      {load(R"({"body": "box", "force": [0, 1, 2], "at": [0, 0]})"), "loads[0].force", "3"},
      {arm(R"("wrench": [0, 0, 0])"), "wrench", "3"},
  };
  for (const Bad& bad : all) {
    SCOPED_TRACE(bad.text);
    try {
      parse_any_grasp(bad.text, "f");
      ADD_FAILURE() << "it was read";
    } catch (const InputError& error) {
      if (bad.place != "1:" && !bad.place.empty()) {
        EXPECT_EQ(error.place(), bad.place);
      }
      EXPECT_THAT(error.problem() + error.remedy(), HasSubstr(bad.words));
      EXPECT_FALSE(error.remedy().empty());
    }
  }
}

TEST(Mechanism, OtherVersionsHaveNoBodies) {
  for (
      const char* rest :
      {R"("wrench": [0, 0, 0], "contacts": [], "bodies": [])",
       R"("wrench": [0, 0, 0], "contacts": [{"of": "a", "position": [0, 0], "normal": [0, 1], "friction": 0}])"}) {
    try {
      parse_any_grasp(std::string(R"({"format": "stickslip-grasp/2", )") + rest + "}", "f");
      ADD_FAILURE() << rest;
    } catch (const InputError& error) {
      EXPECT_THAT(error.remedy(), HasSubstr("stickslip-grasp/3"));
    }
  }
}

TEST(Mechanism, TooManyCoordinates) {
  std::string bodies;
  for (int k = 0; k < 11; ++k) {
    bodies += std::string(k == 0 ? "" : ", ") + "{\"name\": \"b" + std::to_string(k) + "\"}";
  }
  EXPECT_THROW(parse_any_grasp(file(bodies, R"("contacts": [])"), "f"), InputError);
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
  const auto& a = std::get<GraspBox>(once.content);
  const auto& b = std::get<GraspBox>(again.content);
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
