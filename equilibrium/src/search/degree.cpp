// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/search/degree.hpp"

#include <Eigen/LU>
#include <boost/multiprecision/eigen.hpp>

namespace stickslip {

template <std::size_t D>
bool is_invertible(const SquareMatrix<D>& m) {
  constexpr auto kSize = static_cast<int>(D);
  Eigen::Matrix<Rational, kSize, kSize> matrix;
  for (int j = 0; j < kSize; ++j) {
    for (int k = 0; k < kSize; ++k) {
      matrix(j, k) = m[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
    }
  }
  Eigen::FullPivLU<Eigen::Matrix<Rational, kSize, kSize>> lu(matrix);
  lu.setThreshold(0);  // of rationals, whose zeros are zeros
  return lu.isInvertible();
}

template bool is_invertible<3>(const SquareMatrix<3>& matrix);
template bool is_invertible<6>(const SquareMatrix<6>& matrix);

}  // namespace stickslip
