// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/eigen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "random_numbers.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using Eigen::Index;
using testing::Random;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Arguments {
  Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(2, 3);
  Eigen::MatrixXd normals = Eigen::MatrixXd::Ones(2, 3);
  Eigen::VectorXd friction = Eigen::VectorXd::Constant(3, 0.1);
  Eigen::VectorXd stiffness = Eigen::VectorXd::Ones(3);
  Eigen::VectorXd preload = Eigen::VectorXd::Zero(3);

  Grasp grasp() const {
    return grasp_from_eigen(positions, normals, friction, stiffness, preload);
  }

  std::string place_of_error() const {
    try {
      grasp();
    } catch (const InputError& error) {
      return error.place();
    }
    return "no error";
  }
};

TEST(GraspFromEigen, KeepsDoublesExactly) {
  Arguments a;
  a.positions << 0.1, 2, 3, -1e-300, 5, 6;
  const Grasp grasp = a.grasp();
  ASSERT_EQ(grasp.size(), 3U);
  EXPECT_EQ(grasp.contacts()[0].position.x, rational_from_double(0.1));
  EXPECT_NE(grasp.contacts()[0].position.x, Rational(1, 10));
  EXPECT_EQ(grasp.contacts()[0].position.y, rational_from_double(-1e-300));
  EXPECT_EQ(grasp.contacts()[1].friction, rational_from_double(0.1));
  EXPECT_EQ(to_double(MatrixX(positions_matrix(grasp))), a.positions);
  EXPECT_EQ(to_double(MatrixX(normals_matrix(grasp))), a.normals);
}

TEST(GraspFromEigen, TakesBlocksExpressionsAndFixedSizes) {
  const Eigen::Matrix2d p = Eigen::Matrix2d::Identity();
  const Eigen::Vector2d one(1, 1);
  const Grasp grasp = grasp_from_eigen(p, -2 * p, one, p.col(0) + one, 0 * one, "pair");
  EXPECT_EQ(grasp.name(), "pair");
  EXPECT_EQ(grasp.contacts()[0].normal, (Vector2{-2, 0}));
  EXPECT_EQ(grasp.contacts()[0].stiffness, 2);
  EXPECT_EQ(grasp.contacts()[1].stiffness, 1);
}

TEST(GraspFromEigen, NamesEntriesThatAreNotFinite) {
  Arguments a;
  a.normals(0, 2) = kNan;
  EXPECT_EQ(a.place_of_error(), "normals(0,2)");
  a = {};
  a.positions(1, 0) = -kInfinity;
  EXPECT_EQ(a.place_of_error(), "positions(1,0)");
  a = {};
  a.friction(1) = kNan;
  EXPECT_EQ(a.place_of_error(), "friction(1)");
  a = {};
  a.stiffness(2) = kInfinity;
  EXPECT_EQ(a.place_of_error(), "stiffness(2)");
  a = {};
  a.preload(0) = kNan;
  EXPECT_EQ(a.place_of_error(), "preload(0)");
}

TEST(GraspFromEigen, NamesArgumentsOfWrongShape) {
  Arguments a;
  a.positions.setZero(3, 3);
  EXPECT_EQ(a.place_of_error(), "positions");
  a = {};
  a.normals.setOnes(2, 2);
  EXPECT_EQ(a.place_of_error(), "normals");
  a = {};
  a.friction.setOnes(4);
  EXPECT_EQ(a.place_of_error(), "friction");
  a = {};
  a.stiffness.setOnes(0);
  EXPECT_EQ(a.place_of_error(), "stiffness");
  a = {};
  a.preload.setOnes(2);
  EXPECT_EQ(a.place_of_error(), "preload");
  try {
    a.grasp();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "the shape is 2 x 1");
    EXPECT_THAT(error.remedy(), ::testing::HasSubstr("expected 3 x 1"));
  }
}

TEST(GraspFromEigen, PassesOnWhatGraspRefuses) {
  Arguments a;
  a.stiffness(1) = 0;
  EXPECT_EQ(a.place_of_error(), "contacts[1].stiffness");
}

TEST(GraspFromEigen, TakesNoContact) {
  const Grasp grasp =
      grasp_from_eigen(Eigen::MatrixXd(2, 0), Eigen::MatrixXd(2, 0), Eigen::VectorXd(0),
                       Eigen::VectorXd(0), Eigen::VectorXd(0));
  EXPECT_EQ(grasp.size(), 0U);
  EXPECT_EQ(grasp_matrix(grasp).cols(), 0);
  EXPECT_EQ(positions_matrix(grasp).cols(), 0);
}

TEST(GraspFromEigen, RoundTripsRationals) {
  Random random(31);
  const Grasp grasp(random.contacts(6), "six");
  const Grasp again =
      grasp_from_eigen(positions_matrix(grasp), normals_matrix(grasp), friction_vector(grasp),
                       stiffness_vector(grasp), preload_vector(grasp), "six");
  ASSERT_EQ(again.size(), grasp.size());
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    EXPECT_TRUE(testing::same(again.contacts()[i], grasp.contacts()[i]));
  }
  EXPECT_THROW(
      grasp_from_eigen(MatrixX(1, 2), MatrixX(2, 2), VectorX(2), VectorX(2), VectorX(2)),
      InputError);
}

TEST(GraspMatrix, InterleavesNormalAndTangentColumns) {
  Random random(32);
  const Grasp grasp(random.contacts(4));
  const Matrix3X g = grasp_matrix(grasp);
  const Matrix3X n = normal_matrix(grasp);
  const Matrix3X t = tangent_matrix(grasp);
  ASSERT_EQ(g.cols(), 8);
  for (Index i = 0; i < 4; ++i) {
    const Contact& c = grasp.contacts()[static_cast<std::size_t>(i)];
    EXPECT_EQ(g.col(2 * i), n.col(i));
    EXPECT_EQ(g.col(2 * i + 1), t.col(i));
    EXPECT_EQ(wrench_from_eigen(n.col(i)), normal_row(c));
    EXPECT_EQ(wrench_from_eigen(t.col(i)), tangent_row(c));
  }
}

TEST(GraspMatrix, MapsForcesToWrenchesAndTwistsToMotions) {
  Random random(33);
  for (int round = 0; round < 50; ++round) {
    const Grasp grasp(random.contacts(random.integer(0, 7)));
    const Matrix3X g = grasp_matrix(grasp);
    VectorX c(g.cols());
    for (Index i = 0; i < c.size(); ++i) c(i) = random.small();
    const Twist d = random.twist();
    const VectorX motions = g.transpose() * to_eigen(d);
    Wrench sum;
    for (std::size_t i = 0; i < grasp.size(); ++i) {
      const Contact& contact = grasp.contacts()[i];
      const auto at = static_cast<Index>(2 * i);
      sum += c(at) * normal_row(contact) + c(at + 1) * tangent_row(contact);
      EXPECT_EQ(motions(at), power(normal_row(contact), d));
      EXPECT_EQ(motions(at + 1), power(tangent_row(contact), d));
    }
    EXPECT_EQ(wrench_from_eigen(g * c), sum);
    // Virtual work: (G c) . d = c . (G^T d).
    EXPECT_EQ(power(sum, d), c.dot(motions));
  }
}

TEST(TwistAndWrench, ConvertBothWays) {
  const Twist d{Rational(1, 3), -2, Rational(7, 5)};
  const Wrench w{Rational(2, 7), 0, -1};
  EXPECT_EQ(twist_from_eigen(to_eigen(d)), d);
  EXPECT_EQ(wrench_from_eigen(to_eigen(w)), w);
  EXPECT_EQ(to_eigen(w).dot(to_eigen(d)), power(w, d));
  EXPECT_EQ(to_eigen_double(w), Eigen::Vector3d(2.0 / 7.0, 0, -1));
  EXPECT_EQ(to_eigen_double(d), Eigen::Vector3d(1.0 / 3.0, -2, 1.4));
  EXPECT_EQ(twist_from_eigen(Eigen::Vector3d(0.5, -1, 2)), (Twist{Rational(1, 2), -1, 2}));
  EXPECT_EQ(wrench_from_eigen(Eigen::Vector3d(0.5, -1, 2)), (Wrench{Rational(1, 2), -1, 2}));
}

TEST(TwistAndWrench, NameEntriesThatAreNotFinite) {
  const auto place = [](auto&& convert) {
    try {
      convert();
    } catch (const InputError& error) {
      return error.place();
    }
    return std::string("no error");
  };
  EXPECT_EQ(place([] { twist_from_eigen(Eigen::Vector3d(0, kNan, 0)); }), "twist(1)");
  EXPECT_EQ(place([] { wrench_from_eigen(Eigen::Vector3d(0, 0, kNan)); }), "wrench(2)");
}

}  // namespace
}  // namespace stickslip
