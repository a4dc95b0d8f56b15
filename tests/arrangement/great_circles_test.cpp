// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/great_circles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "families.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::Random;
using ::testing::ElementsAre;

std::vector<std::size_t> circle_indices(const GreatCircles& circles) {
  std::vector<std::size_t> indices;
  for (const CircleId id : circles.circle) indices.push_back(id.index());
  return indices;
}

TEST(MergePlanes, NormalsArePrimitiveAndOriented) {
  const GreatCircles circles = merge_planes(
      {{Rational(-4), Rational(6), Rational(0)}, {Rational(0), Rational(0), Rational(-7)}});
  EXPECT_THAT(circles.normals, ElementsAre(IntegerVector3{2, -3, 0}, IntegerVector3{0, 0, 1}));
  EXPECT_THAT(circles.orientation, ElementsAre(Sign::kNegative, Sign::kNegative));
}

TEST(MergePlanes, CircleOrderIsThatOfFirstAppearance) {
  const GreatCircles circles =
      merge_planes({{0, 0, 5}, {1, 2, 3}, {0, 0, -1}, {-2, -4, -6}, {0, 1, 0}, {3, 6, 9}});
  EXPECT_THAT(circle_indices(circles), ElementsAre(0, 1, 0, 1, 2, 1));
  EXPECT_THAT(circles.orientation,
              ElementsAre(Sign::kPositive, Sign::kPositive, Sign::kNegative, Sign::kNegative,
                          Sign::kPositive, Sign::kPositive));
  EXPECT_THAT(circles.normals, ElementsAre(IntegerVector3{0, 0, 1}, IntegerVector3{1, 2, 3},
                                           IntegerVector3{0, 1, 0}));
  EXPECT_EQ(circles.rank, 3);
}

TEST(MergePlanes, ZeroNormalBreaksTheContract) {
  EXPECT_THROW(merge_planes({{0, 0, 0}}), ContractError);
  EXPECT_THROW(merge_planes({{1, 0, 0}, {0, 0, 0}}), ContractError);
}

TEST(MergePlanes, HugeDenominatorsStayExact) {
  const Rational tiny = parse_rational("1e-400");
  const Rational third = parse_rational("1/3");
  const GreatCircles circles = merge_planes({{third, third, 0},
                                             {third + tiny, third, 0},
                                             {tiny, tiny, 0},
                                             {-third * tiny, -third * tiny, 0}});
  EXPECT_THAT(circle_indices(circles), ElementsAre(0, 1, 0, 0));
  EXPECT_EQ(circles.normals[0], (IntegerVector3{1, 1, 0}));
  const Integer power = pow(Integer(10), 400u);
  EXPECT_EQ(circles.normals[1], (IntegerVector3{power + 3, power, 0}));
  EXPECT_EQ(circles.orientation[3], Sign::kNegative);
  EXPECT_EQ(circles.rank, 2);
}

// The two promises at GreatCircles: n_i is a positive multiple of orientation * normal.
TEST(MergePlanes, PlaneIsAPositiveMultipleOfItsOrientedCircle) {
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    std::vector<Vector3> planes;
    for (int i = 0; i < 20; ++i) {
      Vector3 n = random.vector(2);
      const Rational scale(random.between(1, 9), random.between(1, 9));
      for (Rational& entry : n) entry *= scale;
      planes.push_back(n);
    }
    const GreatCircles circles = merge_planes(planes);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const IntegerVector3& normal = circles.normals[circles.circle[i].index()];
      Rational along = 0;
      Rational squared = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        along += planes[i][j] * Rational(normal[j]);
        squared += Rational(normal[j]) * Rational(normal[j]);
      }
      EXPECT_EQ(sign_of(along), circles.orientation[i]);
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_EQ(planes[i][j], along / squared * Rational(normal[j]));
      }
    }
    for (std::size_t a = 0; a < circles.normals.size(); ++a) {
      EXPECT_EQ(gcd(gcd(circles.normals[a][0], circles.normals[a][1]), circles.normals[a][2]),
                1);
      for (std::size_t b = 0; b < a; ++b) EXPECT_NE(circles.normals[a], circles.normals[b]);
    }
  }
}

// T = (t_x, t_y, p_x t_y - p_y t_x) with t = (-n_y, n_x), worked out by hand.
TEST(StickPlanes, Fig1Grasp) {
  EXPECT_THAT(stick_planes(test::fig1_grasp()),
              ElementsAre(Vector3{0, 1, -1}, Vector3{-1, 0, -1}, Vector3{0, -1, -1}));
}

TEST(StickPlanes, Fig4GraspHasTwoCircles) {
  const std::vector<Vector3> planes = stick_planes(test::fig4_grasp());
  EXPECT_THAT(planes, ElementsAre(Vector3{0, 1, -1}, Vector3{0, 1, -1}, Vector3{0, -1, -1},
                                  Vector3{0, -1, -1}));
  const GreatCircles circles = merge_planes(planes);
  EXPECT_THAT(circle_indices(circles), ElementsAre(0, 0, 1, 1));
  EXPECT_EQ(circles.rank, 2);
}

TEST(StickPlanes, NoContacts) {
  EXPECT_TRUE(stick_planes(Grasp()).empty());
}

}  // namespace
}  // namespace stickslip
