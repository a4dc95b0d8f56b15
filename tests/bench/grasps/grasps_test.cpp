// SPDX-License-Identifier: GPL-3.0-or-later
// The families are what bench/grasps/grasps.hpp says they are.
#include "grasps.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "hard.hpp"
#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip::bench {
namespace {

constexpr Layout kLayouts[] = {Layout::kRound, Layout::kArc,  Layout::kEdges, Layout::kGrid,
                               Layout::kJaws,  Layout::kDisc, Layout::kVaried};

std::vector<Contact> contacts_of(Layout layout, std::size_t contacts, bool preloaded,
                                 std::uint64_t seed) {
  return make_grasp(layout, contacts, preloaded, seed).contacts();
}

Rational square(const Vector2& v) {
  return v.x * v.x + v.y * v.y;
}

std::string text_of(const Grasp& grasp) {
  return write_grasp({grasp, {}});
}

/// T up to sign and scale: the contact's great circle.
Vector3 circle_of(const Contact& contact) {
  Vector3 t = coordinates(tangent_row(contact));
  for (const Rational& entry : Vector3(t)) {
    if (entry.is_zero()) continue;
    for (Rational& e : t) e /= entry;
    break;
  }
  return t;
}

TEST(UnitDirections, AreAHundredUnitVectorsInOrder) {
  const std::vector<Vector2>& all = unit_directions();
  ASSERT_EQ(all.size(), 100u);
  EXPECT_EQ(all[0], (Vector2{1, 0}));
  EXPECT_EQ(all[25], (Vector2{0, 1}));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vector2& next = all[(i + 1) % all.size()];
    EXPECT_EQ(square(all[i]), 1) << i;
    EXPECT_EQ(denominator(Rational(4225) * all[i].x), 1) << i;
    EXPECT_GT(all[i].x * next.y - all[i].y * next.x, 0) << i;
    // Less than 8 degrees: cos 8 > 0.99.
    EXPECT_GT(all[i].x * next.x + all[i].y * next.y, Rational(99, 100)) << i;
  }
}

TEST(FloorToGrid, RoundsTowardsMinusInfinity) {
  EXPECT_EQ(floor_to_grid(Rational(7, 3), 10), Rational(23, 10));
  EXPECT_EQ(floor_to_grid(Rational(-7, 3), 10), Rational(-24, 10));
  EXPECT_EQ(floor_to_grid(Rational(-3, 10), 10), Rational(-3, 10));
  EXPECT_EQ(floor_to_grid(0, 1000), 0);
}

TEST(MakeGrasp, IsDeterminedBySizePreloadAndSeed) {
  for (const Layout layout : kLayouts) {
    const std::string once = text_of(make_grasp(layout, 12, true, 5));
    EXPECT_EQ(once, text_of(make_grasp(layout, 12, true, 5))) << name_of(layout);
    EXPECT_NE(once, text_of(make_grasp(layout, 12, true, 6))) << name_of(layout);
  }
}

TEST(MakeGrasp, HasUnitNormalsAndTheAskedPreloads) {
  for (const Layout layout : kLayouts) {
    for (const bool preloaded : {false, true}) {
      const Grasp grasp = make_grasp(layout, 40, preloaded, 1);
      ASSERT_EQ(grasp.size(), 40u);
      for (const Contact& c : grasp.contacts()) {
        EXPECT_EQ(square(c.normal), 1);
        EXPECT_EQ(c.preload.sign(), preloaded ? 1 : 0);
        EXPECT_GT(c.friction, 0);
      }
    }
  }
}

TEST(MakeGrasp, NumbersStayShort) {
  for (const Layout layout : kLayouts) {
    if (layout == Layout::kVaried) continue;
    Rational sum;
    for (const Contact& c : contacts_of(layout, 1000, true, 3)) {
      sum += c.stiffness * tangent_row(c).torque;
    }
    EXPECT_LT(msb(denominator(sum)), 48u) << name_of(layout);
  }
}

TEST(MakeGrasp, VariedContactsShareNoDenominator) {
  Rational sum;
  std::set<Rational> frictions;
  for (const Contact& c : contacts_of(Layout::kVaried, 100, true, 3)) {
    for (const Rational& value : {c.friction, c.stiffness, c.preload, c.normal.x}) {
      EXPECT_LE(denominator(value), 9999999) << value;
    }
    EXPECT_TRUE(c.friction > Rational(1, 5) && c.friction <= Rational(9, 10)) << c.friction;
    EXPECT_TRUE(c.stiffness > 1 && c.stiffness <= 5) << c.stiffness;
    EXPECT_TRUE(c.preload > Rational(1, 4) && c.preload <= 2) << c.preload;
    frictions.insert(c.friction);
    sum += c.stiffness * tangent_row(c).torque;
  }
  EXPECT_EQ(frictions.size(), 100u);
  EXPECT_GT(msb(denominator(sum)), 1000u);
}

TEST(MakeGrasp, ContactsOfAnEdgeShareACircle) {
  std::set<Vector3> circles;
  for (const Contact& c : contacts_of(Layout::kEdges, 30, false, 2)) {
    circles.insert(circle_of(c));
  }
  EXPECT_EQ(circles.size(), 3u);
}

TEST(MakeGrasp, OpenFamiliesDoNotPushDown) {
  for (const Layout layout : {Layout::kArc, Layout::kGrid}) {
    for (const Contact& c : contacts_of(layout, 50, true, 4)) {
      EXPECT_GE(c.normal.y, 0) << name_of(layout);
    }
  }
}

TEST(MakeGrasp, GridCirclesAreConcurrent) {
  // Contacts whose normals are parallel have T with the same first two entries: their circles
  // meet in the translation along the normal.
  std::size_t shared = 0;
  std::set<std::pair<Rational, Rational>> seen;
  for (const Contact& c : contacts_of(Layout::kGrid, 25, false, 1)) {
    if (!seen.insert({c.normal.x, c.normal.y}).second) ++shared;
  }
  EXPECT_EQ(seen.size(), 5u);
  EXPECT_EQ(shared, 20u);
}

TEST(MakeGrasp, JawsAndDiscAreMirrored) {
  const std::vector<Contact> jaws = contacts_of(Layout::kJaws, 7, true, 1);
  const std::vector<Contact> disc = contacts_of(Layout::kDisc, 7, true, 1);
  ASSERT_EQ(jaws.size(), 8u);
  ASSERT_EQ(disc.size(), 8u);
  for (std::size_t i = 0; i < 8; i += 2) {
    EXPECT_EQ(jaws[i].position.y, jaws[i + 1].position.y);
    EXPECT_EQ(jaws[i].position.x, -jaws[i + 1].position.x);
    EXPECT_EQ(jaws[i].preload, jaws[i + 1].preload);
    EXPECT_EQ(jaws[i].stiffness, jaws[i + 1].stiffness);
    EXPECT_EQ(normal_row(disc[i]).torque, 0) << "radial";
    EXPECT_EQ(tangent_row(disc[i]).torque, -2) << "radius 2";
    EXPECT_EQ(disc[i].position.x, -disc[i + 1].position.x);
  }
}

TEST(HardGrasp, AllFamiliesAreThereAndDeterministic) {
  std::set<std::string> names;
  for (std::size_t f = 0; f < kHardFamilies; ++f) {
    const auto family = static_cast<HardFamily>(f);
    names.insert(name_of(family));
    const HardGrasp once = hard_grasp(family, 9, 3);
    EXPECT_EQ(once.grasp.size(), 9u);
    EXPECT_EQ(text_of(once.grasp), text_of(hard_grasp(family, 9, 3).grasp));
    EXPECT_FALSE(once.direction == Wrench{});
  }
  EXPECT_EQ(names.size(), kHardFamilies);
}

}  // namespace
}  // namespace stickslip::bench
