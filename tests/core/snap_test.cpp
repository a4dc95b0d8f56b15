// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/snap.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "random_numbers.hpp"
#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip {
namespace {

using testing::Random;

Rational squared_length(const Vector2& v) {
  return v.x * v.x + v.y * v.y;
}

Grasp with_normal(const Vector2& n) {
  return Grasp({{{1, 2}, n, 1, 1, 1}}, "one");
}

/// |u - n/L| <= bound for a unit vector u. With p = u.n this is 2 - 2p/L <= bound^2; where
/// the right-hand side of p >= L (1 - bound^2/2) is positive, both sides may be squared.
bool within(const Vector2& u, const Vector2& n, const Rational& bound) {
  const Rational p = u.x * n.x + u.y * n.y;
  const Rational factor = 1 - bound * bound / 2;
  return factor.sign() > 0 && p.sign() > 0 && p * p >= squared_length(n) * factor * factor;
}

Vector2 snap_one(const Vector2& n, const Rational& tolerance) {
  const SnapResult result = snap_normals(with_normal(n), tolerance);
  return result.grasp.contacts()[0].normal;
}

const std::vector<std::string> kTolerances = {"0.9", "0.5", "1e-3", "1e-9", "1e-30", "1e-200"};

TEST(SnapNormals, GivesUnitVectorsWithinTheTolerance) {
  Random random(21);
  for (int i = 0; i < 300; ++i) {
    const Vector2 n = random.nonzero_vector();
    if (exact_sqrt(squared_length(n))) continue;
    for (const std::string& text : kTolerances) {
      const Rational tolerance = parse_rational(text);
      SCOPED_TRACE("(" + to_string(n.x) + ", " + to_string(n.y) + ") " + text);
      const SnapResult result = snap_normals(with_normal(n), tolerance);
      ASSERT_EQ(result.snapped.size(), 1U);
      const SnappedNormal& s = result.snapped[0];
      EXPECT_EQ(s.contact, ContactId(0));
      EXPECT_EQ(s.before, (RationalRow{n.x, n.y}));
      const Vector2 after = result.grasp.contacts()[0].normal;
      EXPECT_EQ(s.after, (RationalRow{after.x, after.y}));
      EXPECT_EQ(squared_length(after), 1);
      EXPECT_TRUE(within(after, n, tolerance));
      // `moved` is an upper bound, and not far above the truth.
      const Rational moved = parse_rational(s.moved);
      EXPECT_TRUE(within(after, n, moved)) << s.moved;
      EXPECT_FALSE(within(after, n, moved * Rational(9, 10))) << s.moved;
      EXPECT_LE(s.moved.size(), 9U) << s.moved;
      EXPECT_NO_THROW(contact_rows(result.grasp));
    }
  }
}

TEST(SnapNormals, LeavesRationalLengthsAlone) {
  const std::vector<Contact> contacts = {
      {{0, 0}, {3, 4}, 1, 1, 1},
      {{0, 0}, {0, Rational(-1, 7)}, 1, 1, 1},
      {{0, 0}, {1, 1}, 1, 2, 3},
      {{0, 0}, {Rational(5, 13), Rational(12, 13)}, 1, 1, 1}};
  const SnapResult result = snap_normals(Grasp(contacts, "four"), Rational(1, 1000));
  ASSERT_EQ(result.snapped.size(), 1U);
  EXPECT_EQ(result.snapped[0].contact, ContactId(2));
  EXPECT_EQ(result.grasp.name(), "four");
  for (const std::size_t i : {0U, 1U, 3U}) {
    EXPECT_TRUE(testing::same(result.grasp.contacts()[i], contacts[i]));
  }
  const Contact& changed = result.grasp.contacts()[2];
  EXPECT_EQ(changed.position, contacts[2].position);
  EXPECT_EQ(changed.friction, 1);
  EXPECT_EQ(changed.stiffness, 2);
  EXPECT_EQ(changed.preload, 3);
}

TEST(SnapNormals, OfNothingIsNothing) {
  EXPECT_TRUE(snap_normals(Grasp(), Rational(1, 2)).snapped.empty());
}

TEST(SnapNormals, IsIdempotent) {
  const SnapResult once = snap_normals(with_normal({1, 3}), Rational(1, 1000));
  EXPECT_TRUE(snap_normals(once.grasp, Rational(1, 1000)).snapped.empty());
}

TEST(SnapNormals, RespectsSignsSwapAndScale) {
  Random random(22);
  for (int i = 0; i < 200; ++i) {
    const Vector2 n = random.nonzero_vector();
    if (exact_sqrt(squared_length(n))) continue;
    const Rational tolerance = parse_rational(kTolerances[static_cast<std::size_t>(i) % 5]);
    const Vector2 u = snap_one(n, tolerance);
    EXPECT_EQ(snap_one({-n.x, n.y}, tolerance), (Vector2{-u.x, u.y}));
    EXPECT_EQ(snap_one({n.x, -n.y}, tolerance), (Vector2{u.x, -u.y}));
    EXPECT_EQ(snap_one({n.x * 7 / 3, n.y * 7 / 3}, tolerance), u);
    if (abs(n.x) != abs(n.y)) {
      EXPECT_EQ(snap_one({n.y, n.x}, tolerance), (Vector2{u.y, u.x}));
    }
  }
}

/// The parameter t of u in the first octant, from t = u_y / (1 + u_x).
Rational parameter(const Vector2& u) {
  const Rational x = abs(u.x);
  const Rational y = abs(u.y);
  return y / (1 + x);
}

/// Naive twin: the smallest denominator, then the smallest numerator, that serves.
Rational simplest_by_search(const Vector2& n, const Rational& tolerance) {
  for (int den = 1;; ++den) {
    for (int num = 0; num <= den; ++num) {
      const Rational t(num, den);
      const Rational q = 1 + t * t;
      if (within({(1 - t * t) / q, 2 * t / q}, n, tolerance)) return t;
    }
  }
}

TEST(SnapNormals, FindsTheSimplestFraction) {
  Random random(23);
  for (int i = 0; i < 300; ++i) {
    Vector2 n{abs(random.small()), abs(random.small())};
    if (n.y > n.x) std::swap(n.x, n.y);
    if (exact_sqrt(squared_length(n)) || n.x == n.y) continue;
    const Rational tolerance(1, random.integer(2, 2000));
    EXPECT_EQ(parameter(snap_one(n, tolerance)), simplest_by_search(n, tolerance));
  }
}

TEST(SnapNormals, CopesWithNearlyAxisParallelNormals) {
  const Vector2 n{parse_rational("1e30"), 1};
  EXPECT_EQ(snap_one(n, parse_rational("1e-9")), (Vector2{1, 0}));
  const Vector2 u = snap_one(n, parse_rational("1e-40"));
  EXPECT_EQ(squared_length(u), 1);
  EXPECT_TRUE(within(u, n, parse_rational("1e-40")));
  EXPECT_FALSE(u == (Vector2{1, 0}));
}

GraspBox spatial(const std::vector<Vector3>& normals) {
  GraspBox grasp{{}, WrenchBox(6)};
  for (const Vector3& n : normals) {
    grasp.contacts.push_back(
        {{}, {n.begin(), n.end()}, point_interval(1), point_interval(2), point_interval(3)});
  }
  return grasp;
}

Vector3 snap_one(const Vector3& n, const Rational& tolerance) {
  return vector3(snap_normals(spatial({n}), tolerance).grasp.contacts[0].normal);
}

/// As within() of the plane.
bool within(const Vector3& u, const Vector3& n, const Rational& bound) {
  const Rational p = dot(u, n);
  const Rational factor = 1 - bound * bound / 2;
  return factor.sign() > 0 && p.sign() > 0 && p * p >= dot(n, n) * factor * factor;
}

TEST(SnapNormals, InSpaceGivesUnitVectorsWithinTheTolerance) {
  Random random(24);
  int moved = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector2 v = random.nonzero_vector();
    const Vector3 n{v.x, v.y, random.small()};
    if (exact_sqrt(dot(n, n))) continue;
    for (const std::string& text : kTolerances) {
      const Rational tolerance = parse_rational(text);
      SCOPED_TRACE(to_string(n[0]) + " " + to_string(n[1]) + " " + to_string(n[2]) + " " +
                   text);
      const BoxSnapResult result = snap_normals(spatial({n}), tolerance);
      ASSERT_EQ(result.snapped.size(), 1U);
      const SnappedNormal& s = result.snapped[0];
      EXPECT_EQ(vector3(s.before), n);
      EXPECT_EQ(s.after, result.grasp.contacts[0].normal);
      const Vector3 after = vector3(s.after);
      EXPECT_EQ(dot(after, after), 1);
      EXPECT_TRUE(within(after, n, tolerance));
      const Rational bound = parse_rational(s.moved);
      EXPECT_TRUE(within(after, n, bound)) << s.moved;
      EXPECT_FALSE(within(after, n, bound * Rational(9, 10))) << s.moved;
      EXPECT_LE(s.moved.size(), 9U) << s.moved;
      ++moved;
    }
  }
  EXPECT_GT(moved, 1000);
}

TEST(SnapNormals, InSpaceRespectsSignsSwapsAndScale) {
  Random random(25);
  for (int i = 0; i < 200; ++i) {
    const Vector2 v = random.nonzero_vector();
    const Vector3 n{v.x, v.y, random.small()};
    if (exact_sqrt(dot(n, n))) continue;
    const Rational tolerance = parse_rational(kTolerances[static_cast<std::size_t>(i) % 5]);
    const Vector3 u = snap_one(n, tolerance);
    EXPECT_EQ(snap_one(Vector3{-n[0], n[1], -n[2]}, tolerance), (Vector3{-u[0], u[1], -u[2]}));
    EXPECT_EQ(snap_one(Vector3{n[0] * 7 / 3, n[1] * 7 / 3, n[2] * 7 / 3}, tolerance), u);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_TRUE(!n[j].is_zero() || u[j].is_zero());
    if (abs(n[0]) != abs(n[1]) && abs(n[1]) != abs(n[2]) && abs(n[0]) != abs(n[2])) {
      EXPECT_EQ(snap_one(Vector3{n[2], n[1], n[0]}, tolerance), (Vector3{u[2], u[1], u[0]}));
    }
  }
}

TEST(SnapNormals, ABoxInThePlaneIsSnappedAsOneGrasp) {
  const Grasp grasp({{{0, 0}, {1, 3}, 1, 1, 1}, {{0, 0}, {3, 4}, 1, 1, 1}});
  const Rational tolerance = parse_rational("1e-9");
  const SnapResult one = snap_normals(grasp, tolerance);
  const BoxSnapResult box = snap_normals(box_of(LoadedGrasp{grasp, {}}), tolerance);
  ASSERT_EQ(box.snapped.size(), 1U);
  EXPECT_EQ(box.snapped[0].after, one.snapped[0].after);
  EXPECT_EQ(box.snapped[0].moved, one.snapped[0].moved);
  EXPECT_EQ(write_grasp(box.grasp), write_grasp(LoadedGrasp{one.grasp, {}}));
}

TEST(SnapNormals, InSpaceLeavesRationalLengthsAlone) {
  const GraspBox grasp = spatial({{2, 1, -2}, {1, 1, 1}, {0, 0, Rational(-1, 7)}});
  const BoxSnapResult result = snap_normals(grasp, parse_rational("1e-9"));
  ASSERT_EQ(result.snapped.size(), 1U);
  EXPECT_EQ(result.snapped[0].contact, ContactId(1));
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(result.grasp.contacts[i].normal, grasp.contacts[i].normal);
  }
  EXPECT_EQ(result.grasp.contacts[1].preload, point_interval(3));
  EXPECT_TRUE(snap_normals(result.grasp, parse_rational("1e-12")).snapped.empty());
  // As short as a double's: 62 bits for each number at 1e-9.
  for (const Rational& entry : result.snapped[0].after) {
    EXPECT_LE(mpz_sizeinbase(denominator(entry).gmp(), 2), 63U);
  }
  EXPECT_THROW(snap_normals(grasp, 1), InputError);
}

TEST(SnapNormals, RejectsABadTolerance) {
  for (const Rational& tolerance : {Rational(0), Rational(-1, 2), Rational(1), Rational(2)}) {
    try {
      snap_normals(with_normal({1, 1}), tolerance);
      FAIL() << tolerance;
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), "within");
      EXPECT_THAT(error.problem(), ::testing::HasSubstr(to_string(tolerance)));
      EXPECT_THAT(error.remedy(), ::testing::HasSubstr("between 0 and 1"));
    }
  }
}

}  // namespace
}  // namespace stickslip
