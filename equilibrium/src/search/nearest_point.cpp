// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/search/nearest_point.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip::equilibrium_detail {

bool NearestPoint::affine_minimum(std::array<double, 4>& weights) const {
  // Lagrange: the Gram matrix of the points, bordered by ones, against (0, ..., 0, 1).
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 5, 5>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1>;
  const auto n = static_cast<Eigen::Index>(size_);
  Matrix m = Matrix::Ones(n + 1, n + 1);
  m(n, n) = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) {
      m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          dot(points_[i], points_[j]);
    }
  }
  const Vector solution = m.partialPivLu().solve(Vector(Vector::Unit(n + 1, n)));
  std::copy_n(solution.data(), size_, weights.begin());
  return solution.allFinite();
}

void NearestPoint::remove(std::size_t k) {
  --size_;
  points_[k] = points_[size_];
  weight_[k] = weight_[size_];
  order_[k] = order_[size_];
}

void NearestPoint::update_nearest() {
  nearest_ = {};
  for (std::size_t k = 0; k < size_; ++k) {
    for (std::size_t j = 0; j < 3; ++j) nearest_[j] += weight_[k] * points_[k][j];
  }
}

bool NearestPoint::add(const Double3& point) {
  if (size_ == 4) return false;  // the origin is inside already
  points_[size_] = point;
  weight_[size_] = size_ == 0 ? 1.0 : 0.0;
  order_[size_] = added_++;
  ++size_;
  const double before = dot(nearest_, nearest_);
  const bool first = size_ == 1;
  // Each pass removes a point, so there are at most four.
  while (true) {
    std::array<double, 4> target{};
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

}  // namespace stickslip::equilibrium_detail
