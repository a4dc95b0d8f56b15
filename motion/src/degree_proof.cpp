// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/motion/degree_proof.hpp"

#include <Eigen/LU>
#include <boost/multiprecision/eigen.hpp>

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

}  // namespace stickslip
