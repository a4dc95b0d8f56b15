// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>

namespace stickslip {

Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.partialPivLu().solve(b);
}

Eigen::VectorXd symmetric_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.ldlt().solve(b);
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  if (a.cols() == 0) return Eigen::VectorXd(0);  // Eigen does not decompose it
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& a, std::optional<double> flat,
                               Eigen::MatrixXd* across) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposed;
  if (flat) decomposed.setThreshold(*flat);
  decomposed.compute(a);
  if (across != nullptr) {
    const Eigen::MatrixXd frame =
        decomposed.matrixQ() * Eigen::MatrixXd::Identity(a.rows(), a.rows());
    *across = frame.rightCols(a.rows() - decomposed.rank());
  }
  return decomposed.pseudoInverse();
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& a) {
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(a);
  if (!(std::fabs(lu.determinant()) > 0)) return {};
  return lu.inverse();
}

double determinant(const Eigen::MatrixXd& a) {
  return Eigen::PartialPivLU<Eigen::MatrixXd>(a).determinant();
}

Eigen::Index rank(const Eigen::MatrixXd& a, double flat) {
  return Eigen::FullPivLU<Eigen::MatrixXd>(a).setThreshold(flat).rank();
}

SingularValues singular_values(const Eigen::MatrixXd& a) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

}  // namespace stickslip
