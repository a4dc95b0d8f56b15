// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/motion/degree_proof.hpp"

#include <Eigen/LU>
#include <boost/multiprecision/eigen.hpp>

#include "stickslip/motion/reals.hpp"

namespace stickslip {

std::size_t rank_of(const std::vector<RationalRow>& rows) {
  if (rows.empty()) return 0;
  using Matrix = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix matrix(static_cast<Eigen::Index>(rows.size()),
                static_cast<Eigen::Index>(rows.front().size()));
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t k = 0; k < rows.front().size(); ++k) {
      matrix(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) = rows[j][k];
    }
  }
  Eigen::FullPivLU<Matrix> lu(matrix);
  lu.setThreshold(0);  // of rationals, whose zeros are zeros
  return static_cast<std::size_t>(lu.rank());
}

Direction::Direction(const std::array<std::array<Rational, 5>, 3>& rows) {
  Integer common = 1;
  for (const auto& row : rows) {
    for (const Rational& entry : row) common = lcm(common, denominator(entry));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k < 5; ++k) {
      rows_[j][k] = numerator(rows[j][k]) * (common / denominator(rows[j][k]));
    }
  }
}

bool Direction::holds(const IntegerVector3& y,
                      const std::vector<IntegerVector5>& points) const {
  IntegerVector5 function{};
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k < 5; ++k) function[k] += y[j] * rows_[j][k];
  }
  return std::none_of(points.begin(), points.end(),
                      [&](const IntegerVector5& x) { return dot(function, x).sign() < 0; });
}

std::array<double, 3> Direction::against(const IntegerVector5& x, double length) const {
  IntegerVector3 exact;
  for (std::size_t j = 0; j < 3; ++j) exact[j] = -dot(rows_[j], x);
  std::array<double, 3> result = in_doubles(exact);
  result[2] /= length;
  normalize(result);
  return result;
}

}  // namespace stickslip
