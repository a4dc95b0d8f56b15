// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/search/nearest_point.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip::equilibrium_detail {

template <std::size_t n>
bool NearestPointIn<n>::affine_minimum(std::array<double, n + 1>& weights) const {
  // Lagrange: the Gram matrix of the points, bordered by ones, against (0, ..., 0, 1).
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, n + 2, n + 2>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, n + 2, 1>;
  const auto used = static_cast<Eigen::Index>(size_);
  Matrix m = Matrix::Ones(used + 1, used + 1);
  m(used, used) = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) {
      m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          dot(points_[i], points_[j]);
    }
  }
  const Vector solution = m.partialPivLu().solve(Vector(Vector::Unit(used + 1, used)));
  std::copy_n(solution.data(), size_, weights.begin());
  return solution.allFinite();
}

template <std::size_t n>
void NearestPointIn<n>::remove(std::size_t k) {
  --size_;
  points_[k] = points_[size_];
  weight_[k] = weight_[size_];
  order_[k] = order_[size_];
}

template <std::size_t n>
void NearestPointIn<n>::update_nearest() {
  nearest_ = {};
  for (std::size_t k = 0; k < size_; ++k) {
    for (std::size_t j = 0; j < n; ++j) nearest_[j] += weight_[k] * points_[k][j];
  }
}

template <std::size_t n>
bool NearestPointIn<n>::add(const Point& point) {
  if (size_ == n + 1) return false;  // the origin is inside already
  points_[size_] = point;
  weight_[size_] = size_ == 0 ? 1.0 : 0.0;
  order_[size_] = added_++;
  ++size_;
  const double before = dot(nearest_, nearest_);
  const bool first = size_ == 1;
  // Each pass removes a point, so there are at most n + 1.
  while (true) {
    std::array<double, n + 1> target{};
    if (!affine_minimum(target)) return false;
    double step = 1;
    for (std::size_t k = 0; k < size_; ++k) {
      if (target[k] < 0) step = std::fmin(step, weight_[k] / (weight_[k] - target[k]));
    }
    for (std::size_t k = 0; k < size_; ++k) {
      weight_[k] = step < 1 ? weight_[k] + step * (target[k] - weight_[k]) : target[k];
    }
    if (step == 1) break;
    bool removed = false;
    for (std::size_t k = size_; k-- > 0;) {
      if (weight_[k] <= 1e-15 && target[k] < 0) {
        remove(k);
        removed = true;
      }
    }
    if (!removed || size_ == 0) return false;
  }
  update_nearest();
  return first || dot(nearest_, nearest_) < before;
}

template class NearestPointIn<3>;
template class NearestPointIn<6>;

}  // namespace stickslip::equilibrium_detail
