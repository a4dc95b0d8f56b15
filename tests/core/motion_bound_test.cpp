// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/motion_bound.hpp"

#include <gtest/gtest.h>

#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip {
namespace {

/// Two fingers at (-+x, 0) that press with P, and a load.
GraspBox pinch(const Rational& x, const Rational& preload, const Rational& stiffness,
               const RationalRow& load) {
  GraspBox box;
  for (const int side : {-1, 1}) {
    UncertainContact& c = box.contacts.emplace_back();
    c.position = {point_interval(side * x), point_interval(0)};
    c.normal = {-side, 0};
    c.friction = point_interval(Rational(1, 2));
    c.stiffness = point_interval(stiffness);
    c.preload = point_interval(preload);
  }
  for (const Rational& w : load) box.wrench.push_back(point_interval(w));
  return box;
}

// delta = (|w| + sum of P) / k = (1 + 4) / 10; rotations count at the half spread, 2, and a
// translation is that of the origin, twice as far where the farthest contact is as far away.
TEST(NaturalBound, IsHowFarTheLoadPressesTheSoftestContact) {
  EXPECT_EQ(*natural_bound(pinch(2, 2, 10, {0, -1, 0}), 1),
            (RationalRow{1, 1, Rational(1, 4)}));
  EXPECT_EQ(*natural_bound(pinch(2, 2, 10, {0, -1, 0}), 1000), (RationalRow{1000, 1000, 250}));
  // A torque counts by the force that it is at the half spread, about the contacts' middle.
  EXPECT_EQ(*natural_bound(pinch(2, 2, 10, {0, 0, -2}), 1),
            (RationalRow{1, 1, Rational(1, 4)}));
}

TEST(NaturalBound, DoesNotDependOnUnits) {
  const RationalRow bound = *natural_bound(pinch(2, 2, 10, {0, -1, 0}), 1);
  for (const Rational& s : {Rational(1, 1000), Rational(10), Rational(10000)}) {
    // Lengths times s, so forces per length over s.
    const RationalRow longer = *natural_bound(pinch(2 * s, 2, Rational(10) / s, {0, -1, 0}), 1);
    EXPECT_EQ(longer, (RationalRow{s * bound[0], s * bound[1], bound[2]})) << s;
    const RationalRow stronger = *natural_bound(pinch(2, 2 * s, 10 * s, {0, -s, 0}), 1);
    EXPECT_EQ(stronger, bound) << s;
  }
}

TEST(NaturalBound, IsRoundedUpToTwoDigits) {
  const RationalRow bound = *natural_bound(pinch(1, 1, 3, {0, -1, 0}), 1);
  EXPECT_EQ(bound[2], Rational(1));                                                  // 3 / 3
  EXPECT_EQ((*natural_bound(pinch(1, 1, 7, {0, -1, 0}), 1))[2], Rational(43, 100));  // 3 / 7
}

TEST(NaturalBound, NeedsContactsAndForces) {
  EXPECT_FALSE(natural_bound(pinch(1, 0, 1, {0, 0, 0}), 1));
  GraspBox free = pinch(1, 1, 1, {0, 1, 0});
  free.contacts.clear();
  EXPECT_FALSE(natural_bound(free, 1));
}

std::string problem_with(const std::string& text) {
  try {
    static_cast<void>(bound_of(pinch(1, 1, 1, {0, 1, 0}), parse_motion_bound(text)));
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "max_motion");
    EXPECT_FALSE(error.remedy().empty());
    return error.problem();
  }
  return "";
}

TEST(MotionBound, IsSpelledInFourWays) {
  const GraspBox grasp = pinch(1, 1, 3, {0, -1, 0});
  const auto read = [&](const char* text) { return bound_of(grasp, parse_motion_bound(text)); };
  EXPECT_EQ(read("1/10,2"), (RationalRow{Rational(1, 10), Rational(1, 10), 2}));
  EXPECT_EQ(read("1,2,3e-1"), (RationalRow{1, 2, Rational(3, 10)}));
  EXPECT_EQ(read("1000x"), *natural_bound(grasp, 1000));
  EXPECT_EQ(read("none"), RationalRow{});
}

TEST(MotionBound, SaysWhatIsWrong) {
  EXPECT_EQ(problem_with("0,1"), "a bound of motions is 0");
  EXPECT_EQ(problem_with("1"), "there is 1 number for 3 coordinates of motions");
  EXPECT_EQ(problem_with("1,2,3,4"), "there are 4 numbers for 3 coordinates of motions");
  EXPECT_EQ(problem_with("0x"), "the factor is 0");
  EXPECT_NE(problem_with("much"), "");
  EXPECT_NE(problem_with("1,,2"), "");
}

TEST(MotionBound, StandsInFilesAndIsWrittenAgain) {
  const char* head = R"({"format": "stickslip-grasp/2", "max_motion": )";
  const char* rest = R"(, "contacts": [], "wrench": [0, 0, 0]})";
  const auto bound_in = [&](const std::string& written) {
    const GraspFile file = parse_any_grasp(head + written + rest, "f");
    const GraspFile again = parse_any_grasp(write_grasp_file(file), "again");
    EXPECT_EQ(again.content.box()->max_motion, file.content.box()->max_motion);
    return file.content.box()->max_motion;
  };
  EXPECT_EQ(bound_in(R"({"length": "1/2", "angle": 3})"),
            (RationalRow{Rational(1, 2), Rational(1, 2), 3}));
  EXPECT_EQ(bound_in("[1, 2, 0.5]"), (RationalRow{1, 2, Rational(1, 2)}));
  EXPECT_THROW(bound_in("[1, 2]"), InputError);
  EXPECT_THROW(parse_grasp(std::string(head) + "[1, 2, 3]" + rest, "f"), InputError);
}

}  // namespace
}  // namespace stickslip
