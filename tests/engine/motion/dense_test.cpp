// SPDX-License-Identifier: GPL-3.0-or-later
// Dense linear algebra by the equations that define each result.
#include "engine/motion/dense.hpp"

#include <gtest/gtest.h>

#include "random_grasps.hpp"

namespace stickslip {
namespace dense_test {

using test::RandomSource;

Eigen::MatrixXd random_matrix(RandomSource& random, Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd a(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < columns; ++j) a(i, j) = random.between(-3, 3);
  }
  return a;
}

/// A matrix of at most this rank.
Eigen::MatrixXd of_rank(RandomSource& random, Eigen::Index rows, Eigen::Index columns,
                        Eigen::Index rank) {
  return random_matrix(random, rows, rank) * random_matrix(random, rank, columns);
}

constexpr double kNearly = 1e-8;

void expect_equal(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  if (a.size() > 0) {
    EXPECT_LE((a - b).lpNorm<Eigen::Infinity>(), kNearly * (1 + b.lpNorm<Eigen::Infinity>()));
  }
}

// The four equations of Penrose, and what is across all columns.
TEST(Dense, PseudoInversesSatisfyPenrose) {
  RandomSource random(291);
  for (int round = 0; round < 200; ++round) {
    const Eigen::Index rows = random.between(1, 5);
    const Eigen::Index columns = random.between(1, 5);
    const Eigen::MatrixXd a = of_rank(random, rows, columns, random.between(1, 4));
    Eigen::MatrixXd across;
    const Eigen::MatrixXd p = pseudo_inverse(a, {}, &across);
    expect_equal(a * p * a, a);
    expect_equal(p * a * p, p);
    expect_equal((a * p).transpose(), a * p);
    expect_equal((p * a).transpose(), p * a);
    EXPECT_EQ(across.cols() + rank(a, 1e-9), rows);
    expect_equal(across.transpose() * across,
                 Eigen::MatrixXd::Identity(across.cols(), across.cols()));
    expect_equal(a.transpose() * across, Eigen::MatrixXd::Zero(columns, across.cols()));
    const Eigen::VectorXd b = random_matrix(random, rows, 1);
    expect_equal(least_squares(a, b), p * b);
  }
  EXPECT_EQ(least_squares(Eigen::MatrixXd(3, 0), Eigen::VectorXd::Ones(3)).size(), 0);
}

// Pivots below the part `flat` count as 0.
TEST(Dense, FlatDirectionsCountAsNone) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(3, 3);
  a(2, 2) = 1e-6;
  EXPECT_EQ(rank(a, 1e-5), 2);
  EXPECT_EQ(rank(a, 1e-7), 3);
  EXPECT_NEAR(pseudo_inverse(a, 1e-5)(2, 2), 0, kNearly);
  EXPECT_NEAR(pseudo_inverse(a, 1e-7)(2, 2), 1e6, 1);
}

TEST(Dense, SolutionsInversesAndSingularValues) {
  RandomSource random(292);
  int singular = 0;
  for (int round = 0; round < 200; ++round) {
    const Eigen::Index n = random.between(1, 5);
    const Eigen::MatrixXd a = random_matrix(random, n, n);
    const SingularValues found = singular_values(a);
    expect_equal(found.left * found.values.asDiagonal() * found.right.transpose(), a);
    expect_equal(found.left.transpose() * found.left, Eigen::MatrixXd::Identity(n, n));
    expect_equal(found.right.transpose() * found.right, Eigen::MatrixXd::Identity(n, n));
    for (Eigen::Index k = 0; k + 1 < n; ++k) EXPECT_GE(found.values[k], found.values[k + 1]);
    EXPECT_GE(found.values[n - 1], 0);
    if (found.values[n - 1] < 1e-6) {
      ++singular;
      continue;
    }
    expect_equal(inverse(a) * a, Eigen::MatrixXd::Identity(n, n));
    const Eigen::VectorXd b = random_matrix(random, n, 1);
    expect_equal(a * solution(a, b), b);
  }
  EXPECT_GE(singular, 10);
  EXPECT_EQ(inverse(Eigen::MatrixXd::Zero(2, 2)).size(), 0);
}

}  // namespace dense_test
}  // namespace stickslip
