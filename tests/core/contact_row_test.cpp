// SPDX-License-Identifier: GPL-3.0-or-later
// Grasp (grasp.hpp) and the rows of its contacts (contact_row.hpp); the paper's Figs. 1 and 4.
#include "stickslip/core/contact_row.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "random_numbers.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using ::testing::HasSubstr;
using testing::Random;

const Rational kHalf(1, 2);

std::vector<Contact> fig1() {
  return {{{-1, 0}, {1, 0}, kHalf, 1, 1},
          {{0, -1}, {0, 1}, kHalf, 1, 1},
          {{1, 0}, {-1, 0}, kHalf, 1, 1}};
}

/// p + (x - r p_y, y + r p_x) - p: the motion of a contact point, from the definition.
Vector2 motion(const Vector2& p, const Twist& d) {
  return {d.x - d.r * p.y, d.y + d.r * p.x};
}

TEST(Grasp, NamesTheMemberThatIsWrong) {
  const auto place_of_error = [](void (*spoil)(Contact&)) {
    std::vector<Contact> contacts = fig1();
    spoil(contacts[2]);
    try {
      const Grasp grasp(contacts);
    } catch (const InputError& error) {
      return error.place();
    }
    return std::string("no error");
  };
  EXPECT_EQ(place_of_error([](Contact& c) { c.normal = {0, 0}; }), "contacts[2].normal");
  EXPECT_EQ(place_of_error([](Contact& c) { c.friction = -kHalf; }), "contacts[2].friction");
  EXPECT_EQ(place_of_error([](Contact& c) { c.stiffness = 0; }), "contacts[2].stiffness");
  EXPECT_EQ(place_of_error([](Contact& c) { c.stiffness = -1; }), "contacts[2].stiffness");
  EXPECT_EQ(place_of_error([](Contact& c) { c.preload = -1; }), "contacts[2].preload");
  EXPECT_EQ(place_of_error([](Contact& c) { c.friction = 0; }), "no error");
  EXPECT_EQ(place_of_error([](Contact& c) { c.preload = 0; }), "no error");
}

TEST(Grasp, WithPreloadReplacesAllOfThem) {
  const Grasp grasp = Grasp(fig1(), "f").with_preload(7);
  for (const Contact& c : grasp.contacts()) EXPECT_EQ(c.preload, 7);
  EXPECT_EQ(grasp.name(), "f");
  EXPECT_THROW(grasp.with_preload(-1), InputError);
}

TEST(NormalLaw, HasNames) {
  EXPECT_STREQ(to_string(NormalLaw::kUnilateral), "unilateral");
  EXPECT_STREQ(to_string(NormalLaw::kBilateral), "bilateral");
}

TEST(ContactRows, OfFig1) {
  const std::vector<ContactRow> rows = contact_rows(Grasp(fig1()));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].normal, (Wrench{1, 0, 0}));
  EXPECT_EQ(rows[0].tangent, (Wrench{0, 1, -1}));
  EXPECT_EQ(rows[1].normal, (Wrench{0, 1, 0}));
  EXPECT_EQ(rows[1].tangent, (Wrench{-1, 0, -1}));
  EXPECT_EQ(rows[2].normal, (Wrench{-1, 0, 0}));
  EXPECT_EQ(rows[2].tangent, (Wrench{0, -1, -1}));
  for (const ContactRow& row : rows) {
    EXPECT_EQ(row.friction, kHalf);
    EXPECT_EQ(row.preload, 1);
    EXPECT_EQ(row.stiffness, 1);
  }
}

TEST(ContactRows, MeasureTheMotionOfTheContactPoint) {
  Random random(11);
  for (int i = 0; i < 500; ++i) {
    const Contact c = random.contact();
    const Twist d = random.twist();
    const Vector2 moved = motion(c.position, d);
    EXPECT_EQ(power(normal_row(c), d), moved.x * c.normal.x + moved.y * c.normal.y);
    EXPECT_EQ(power(tangent_row(c), d), moved.y * c.normal.x - moved.x * c.normal.y);
  }
}

TEST(ContactRows, AreTheSameInAndBeyondMachineWords) {
  Random random(14);
  const auto number = [&] {
    return random.integer(0, 1) == 0 ? random.extreme() : random.small();
  };
  for (int i = 0; i < 20000; ++i) {
    const Vector2 p{number(), number()};
    const Vector2 n{number(), number()};
    if (n == Vector2{}) continue;
    const ContactRow row = contact_rows(Grasp({{p, n, kHalf, 3, 0}}))[0];
    EXPECT_EQ(row.normal, (Wrench{n.x, n.y, p.x * n.y - p.y * n.x}));
    EXPECT_EQ(row.tangent, (Wrench{-n.y, n.x, p.x * n.x + p.y * n.y}));
    EXPECT_EQ(row.stiffness, 3 / (n.x * n.x + n.y * n.y));
  }
}

TEST(ContactRows, ScaleWithTheLengthOfTheNormal) {
  Contact c{{1, 2}, {Rational(3, 5), Rational(4, 5)}, kHalf, 3, 7};
  const ContactRow unit = contact_rows(Grasp({c}))[0];
  c.normal = {6, 8};
  const ContactRow scaled = contact_rows(Grasp({c}))[0];
  EXPECT_EQ(scaled.normal, 10 * unit.normal);
  EXPECT_EQ(scaled.tangent, 10 * unit.tangent);
  EXPECT_EQ(scaled.friction, unit.friction);
  EXPECT_EQ(scaled.preload, unit.preload / 10);
  EXPECT_EQ(scaled.stiffness, unit.stiffness / 100);
  // The force a N is the same for every motion.
  Random random(13);
  for (int i = 0; i < 100; ++i) {
    const Twist d = random.twist();
    EXPECT_EQ(scaled.normal_coefficient(d) * scaled.normal,
              unit.normal_coefficient(d) * unit.normal);
  }
}

TEST(ContactRows, WithoutPreloadTakeAnIrrationalLength) {
  const ContactRow row = contact_rows(Grasp({{{0, 0}, {1, 1}, kHalf, 3, 0}}))[0];
  EXPECT_EQ(row.preload, 0);
  EXPECT_EQ(row.stiffness, Rational(3, 2));
}

TEST(ContactRows, WithPreloadRefuseAnIrrationalLength) {
  std::vector<Contact> contacts = fig1();
  contacts[1].normal = {1, Rational(1, 2)};
  try {
    contact_rows(Grasp(contacts));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "contacts[1].normal");
    EXPECT_THAT(error.problem(), HasSubstr("(1, 1/2)"));
    EXPECT_THAT(error.problem(), HasSubstr("irrational length sqrt(5/4)"));
    EXPECT_THAT(error.remedy(), HasSubstr("stickslip snap GRASP -o FILE"));
  }
}

}  // namespace
}  // namespace stickslip
