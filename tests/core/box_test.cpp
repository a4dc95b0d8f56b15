// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/box.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "error_of.hpp"
#include "random_numbers.hpp"

namespace stickslip {
namespace {

using test::error_of;
using ::testing::HasSubstr;
using testing::Random;
using testing::same;

LoadedGrasp one_contact() {
  return {Grasp({{{1, -2}, {3, 4}, Rational(1, 2), 4, 3}}), {5, -10, 0}};
}

void expect_same(const GraspBox& a, const GraspBox& b) {
  EXPECT_EQ(a.wrench, b.wrench);
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t i = 0; i < a.contacts.size(); ++i) {
    const UncertainContact& c = a.contacts[i];
    const UncertainContact& d = b.contacts[i];
    EXPECT_TRUE(c.position == d.position && c.normal == d.normal && c.slope == d.slope &&
                c.friction == d.friction && c.stiffness == d.stiffness &&
                c.preload == d.preload)
        << i;
  }
}

TEST(Tolerance, AbsoluteAndRelative) {
  EXPECT_EQ((Tolerance{Rational(1, 10), false}.widen({-2, 3})),
            (Interval{Rational(-21, 10), Rational(31, 10)}));
  // [A - t|A|, B + t|B|]: outwards whatever the signs.
  const Tolerance tenth{Rational(1, 10), true};
  EXPECT_EQ(tenth.widen({2, 3}), (Interval{Rational(18, 10), Rational(33, 10)}));
  EXPECT_EQ(tenth.widen({-3, -2}), (Interval{Rational(-33, 10), Rational(-18, 10)}));
  EXPECT_EQ(tenth.widen({-3, 0}), (Interval{Rational(-33, 10), 0}));
}

TEST(Tolerances, AreReadExactly) {
  const Tolerances t = parse_tolerances(
      "friction=10%,stiffness=1/3%,preload=0,position=1e-3,normal=0.0175,"
      "wrench=1/7");
  EXPECT_EQ(t.friction, (Tolerance{Rational(1, 10), true}));
  EXPECT_EQ(t.stiffness, (Tolerance{Rational(1, 300), true}));
  EXPECT_EQ(t.preload, (Tolerance{0, false}));
  EXPECT_EQ(t.position, (Tolerance{Rational(1, 1000), false}));
  EXPECT_EQ(t.normal, (Tolerance{Rational(7, 400), false}));
  EXPECT_EQ(t.wrench, (Tolerance{Rational(1, 7), false}));
  EXPECT_TRUE(t.any());
  EXPECT_FALSE(Tolerances{}.any());
  const Tolerances one = parse_tolerances("wrench=2%");
  EXPECT_EQ(one.wrench, (Tolerance{Rational(1, 50), true}));
  EXPECT_FALSE(one.friction || one.stiffness || one.preload || one.position || one.normal);
}

TEST(Tolerances, BadOnesSayWhatIsRight) {
  const struct {
    const char* text;
    const char* problem;
    const char* remedy;
  } bad[] = {{"", "found \"\"", "friction=10%"},
             {"friction", "found \"friction\"", "friction=10%"},
             {"friction=1,", "found \"\"", "friction=10%"},
             {"fricton=1", "no kind of number \"fricton\"", "did you mean \"friction\"?"},
             {"mu=1", "no kind of number \"mu\"", "the kinds are friction, stiffness"},
             {"friction=1,friction=1", "friction is given twice", "once"},
             {"friction=", "\"\" is not a number", "friction=0.01"},
             {"friction=%", "\"\" is not a number", "a percentage such as 10%"},
             {"friction=1%%", "\"1%\" is not a number", "a percentage such as 10%"},
             {"friction=nan", "nan", "a percentage such as 10%"},
             {"friction= 1", "\" 1\"", "a percentage such as 10%"},
             {"preload=-1/2", "preload is -1/2", "0 or more"},
             {"wrench=-1%", "wrench is -1", "0 or more"},
             {"normal=1%", "a percentage of a normal", "slope"}};
  for (const auto& [text, problem, remedy] : bad) {
    const InputError error = error_of([text = text] { parse_tolerances(text); });
    EXPECT_EQ(error.place(), "uncertain") << text;
    EXPECT_THAT(error.problem(), HasSubstr(problem)) << text;
    EXPECT_THAT(error.remedy(), HasSubstr(remedy)) << text;
  }
}

TEST(GraspBox, OfOneGraspIsThatGrasp) {
  Random random(1701);
  for (int i = 0; i < 50; ++i) {
    const LoadedGrasp loaded{Grasp(random.contacts(random.integer(0, 4))), random.wrench()};
    GraspBox box = box_of(loaded);
    EXPECT_TRUE(box.is_point());
    box.description.name = "named";
    const LoadedGrasp again = loaded_of(box);
    EXPECT_EQ(again.grasp.name(), "named");
    EXPECT_EQ(again.wrench, loaded.wrench);
    ASSERT_EQ(again.grasp.size(), loaded.grasp.size());
    for (std::size_t j = 0; j < loaded.grasp.size(); ++j) {
      EXPECT_TRUE(same(again.grasp.contacts()[j], loaded.grasp.contacts()[j]));
    }
    expect_same(box.widened({}), box);
    expect_same(box.scaled(box, 3), box);
  }
}

TEST(GraspBox, EachKindWidensItsNumbersAndNoOthers) {
  const GraspBox point = box_of(one_contact());
  const Rational tenth(1, 10);
  GraspBox expected = point;
  expected.contacts[0].friction = {Rational(9, 20), Rational(11, 20)};
  expect_same(point.widened(parse_tolerances("friction=10%")), expected);
  expected = point;
  expected.contacts[0].stiffness = {3, 5};
  expect_same(point.widened(parse_tolerances("stiffness=1")), expected);
  expected = point;
  expected.contacts[0].preload = {0, 6};
  expect_same(point.widened(parse_tolerances("preload=100%")), expected);
  expected = point;
  expected.contacts[0].position[0] = {1 - tenth, 1 + tenth};
  expected.contacts[0].position[1] = {-2 - tenth, -2 + tenth};
  expect_same(point.widened(parse_tolerances("position=0.1")), expected);
  expected = point;
  expected.contacts[0].slope = tenth;
  expect_same(point.widened(parse_tolerances("normal=0.1")), expected);
  EXPECT_FALSE(expected.is_point());
  expected = point;
  expected.wrench = {Interval{Rational(9, 2), Rational(11, 2)}, Interval{-11, -9}, Interval{}};
  expect_same(point.widened(parse_tolerances("wrench=10%")), expected);
}

TEST(GraspBox, BadBoxesNameTheirPlace) {
  const GraspBox point = box_of(one_contact());
  const auto place_if = [&](const char* tolerances) {
    return error_of([&] { point.widened(parse_tolerances(tolerances)); }).place();
  };
  EXPECT_EQ(place_if("friction=0.51"), "contacts[0].friction");
  EXPECT_EQ(place_if("friction=0.5"), "");
  EXPECT_EQ(place_if("stiffness=4"), "contacts[0].stiffness");
  EXPECT_EQ(place_if("stiffness=99.9%"), "");
  EXPECT_EQ(place_if("stiffness=100%"), "contacts[0].stiffness");
  EXPECT_EQ(place_if("preload=3.01"), "contacts[0].preload");
  EXPECT_EQ(place_if("preload=3"), "");
  EXPECT_EQ(place_if("normal=1"), "contacts[0].normal");
  EXPECT_EQ(place_if("normal=0.999"), "");
  const auto place_of = [&](const std::function<void(GraspBox&)>& spoil) {
    GraspBox box = point;
    spoil(box);
    return error_of([&] { box.widened({}); }).place();
  };
  const Interval exchanged{Rational(2), Rational(1)};
  EXPECT_EQ(place_of([&](GraspBox& b) { b.contacts[0].position[0] = exchanged; }),
            "contacts[0].position[0]");
  EXPECT_EQ(place_of([&](GraspBox& b) { b.contacts[0].position[1] = exchanged; }),
            "contacts[0].position[1]");
  EXPECT_EQ(place_of([&](GraspBox& b) { b.contacts[0].friction = exchanged; }),
            "contacts[0].friction");
  EXPECT_EQ(place_of([&](GraspBox& b) { b.contacts[0].stiffness = exchanged; }),
            "contacts[0].stiffness");
  EXPECT_EQ(place_of([&](GraspBox& b) { b.contacts[0].preload = exchanged; }),
            "contacts[0].preload");
  EXPECT_EQ(place_of([&](GraspBox& b) { b.wrench[2] = exchanged; }), "wrench[2]");
  EXPECT_EQ(place_of([&](GraspBox& b) { b.contacts[0].slope = -1; }), "contacts[0].normal");
  // Exchanged ends are not mended by widening them past each other.
  GraspBox box = point;
  box.wrench[0] = exchanged;
  EXPECT_THROW(box.widened(parse_tolerances("wrench=5")), InputError);
}

TEST(GraspBox, IsScaledAboutAGraspInIt) {
  const GraspBox centre = box_of(one_contact());
  GraspBox box = centre.widened(parse_tolerances("friction=1/4,normal=1/8"));
  box.contacts[0].preload = {2, 5};  // about 3, not in the middle
  const GraspBox half = box.scaled(centre, Rational(1, 2));
  EXPECT_EQ(half.contacts[0].friction, (Interval{Rational(3, 8), Rational(5, 8)}));
  EXPECT_EQ(half.contacts[0].preload, (Interval{Rational(5, 2), 4}));
  EXPECT_EQ(half.contacts[0].slope, Rational(1, 16));
  EXPECT_EQ(half.contacts[0].position[0], point_interval(1));
  expect_same(half.scaled(centre, 2), box);
  expect_same(box.scaled(centre, 0), centre);
  EXPECT_NO_THROW(box.scaled(centre, 2));
  EXPECT_EQ(error_of([&] { box.scaled(centre, Rational(201, 100)); }).place(),
            "contacts[0].friction");
  GraspBox outside = centre;
  outside.wrench[0] = point_interval(6);
  EXPECT_THROW(box.scaled(outside, 1), ContractError);
  EXPECT_THROW(box.scaled(centre, -1), ContractError);
}

}  // namespace
}  // namespace stickslip
