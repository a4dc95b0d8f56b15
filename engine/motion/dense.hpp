// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Dense linear algebra in double precision: Eigen's decompositions, which take a compiler
/// long, are compiled here alone. Proposals only.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace stickslip {

/// The x with a x = b of a square matrix, by Gaussian elimination with partial pivoting; not
/// finite, or far off, where a is singular. O(n^3), as all of these.
Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// The shortest of the x for which |a x - b| is least.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// The inverse of Moore and Penrose: least_squares(a, b) is pseudo_inverse(a) b. Pivots up to
/// this part of the largest are taken for 0, by default what rounding leaves. `across` becomes
/// an orthonormal basis, by columns, of the vectors across all columns of a.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& a, std::optional<double> flat = {},
                               Eigen::MatrixXd* across = nullptr);

/// The inverse of a square matrix; of no rows if its determinant is 0 or no number.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);

/// How many pivots of Gaussian elimination are above this part of the largest.
Eigen::Index rank(const Eigen::MatrixXd& a, double flat);

/// a = left diag(values) right^T of a matrix a.
struct SingularValues {
  Eigen::MatrixXd left;    ///< orthogonal
  Eigen::VectorXd values;  ///< not negative, descending
  Eigen::MatrixXd right;   ///< orthogonal
};
/// The decomposition by singular values.
SingularValues singular_values(const Eigen::MatrixXd& a);

}  // namespace stickslip
