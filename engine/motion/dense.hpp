// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Dense linear algebra in double precision, for proposals only. Eigen's decompositions are
/// compiled here alone, as they take a compiler long.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace stickslip {

/// Returns the x with a x = b, for a square matrix, by Gaussian elimination with partial
/// pivoting. It is not finite, or far off, if a is singular. O(n^3), as all of these.
Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Returns the x with a x = b, for a symmetric matrix with no negative eigenvalue, of which
/// only the lower triangle is read, by Cholesky's method with pivoting.
Eigen::VectorXd symmetric_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Returns the shortest of the x for which |a x - b| is least.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Returns the inverse of Moore and Penrose: least_squares(a, b) is pseudo_inverse(a) b. Pivots
/// of at most `flat` times the largest count as 0; the default is what rounding leaves.
/// `across`, if given, becomes an orthonormal basis, by columns, of the vectors across all
/// columns of a.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& a, std::optional<double> flat = {},
                               Eigen::MatrixXd* across = nullptr);

/// Returns the inverse of a square matrix, or one of no rows if its determinant is 0 or no
/// number.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);

/// Returns the determinant of a square matrix.
double determinant(const Eigen::MatrixXd& a);

/// Returns how many pivots of Gaussian elimination are above `flat` times the largest.
Eigen::Index rank(const Eigen::MatrixXd& a, double flat);

/// The decomposition a = left diag(values) right^T of a matrix a.
struct SingularValues {
  Eigen::MatrixXd left;    ///< orthogonal
  Eigen::VectorXd values;  ///< not negative, descending
  Eigen::MatrixXd right;   ///< orthogonal
};
/// Returns the decomposition by singular values.
SingularValues singular_values(const Eigen::MatrixXd& a);

}  // namespace stickslip
