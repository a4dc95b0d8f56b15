// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/search/degree.hpp"

#include <Eigen/LU>
#include <boost/multiprecision/eigen.hpp>

namespace stickslip {

template <std::size_t D>
std::size_t rank_of(const std::vector<std::array<Rational, D>>& rows) {
  using Matrix = Eigen::Matrix<Rational, Eigen::Dynamic, static_cast<int>(D)>;
  Matrix matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(D));
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t k = 0; k < D; ++k) {
      matrix(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) = rows[j][k];
    }
  }
  Eigen::FullPivLU<Matrix> lu(matrix);
  lu.setThreshold(0);  // of rationals, whose zeros are zeros
  return static_cast<std::size_t>(lu.rank());
}

template std::size_t rank_of<3>(const std::vector<std::array<Rational, 3>>& rows);
template std::size_t rank_of<6>(const std::vector<std::array<Rational, 6>>& rows);

}  // namespace stickslip
