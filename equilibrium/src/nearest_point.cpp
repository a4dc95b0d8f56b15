// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_point.hpp"

#include <cmath>
#include <utility>

namespace stickslip {

bool NearestPoint::affine_minimum(std::array<double, 4>& weights) const {
  // Lagrange: the Gram matrix of the points, bordered by ones, against (0, ..., 0, 1).
  const std::size_t n = size_ + 1;
  double m[5][6] = {};
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) m[i][j] = dot(points_[i], points_[j]);
    m[i][size_] = m[size_][i] = 1;
  }
  m[size_][n] = 1;
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r) {
      if (std::fabs(m[r][c]) > std::fabs(m[pivot][c])) pivot = r;
    }
    if (std::fabs(m[pivot][c]) < 1e-300) return false;
    if (pivot != c) {
      for (std::size_t k = 0; k <= n; ++k) std::swap(m[pivot][k], m[c][k]);
    }
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c || m[r][c] == 0) continue;
      const double factor = m[r][c] / m[c][c];
      for (std::size_t k = c; k <= n; ++k) m[r][k] -= factor * m[c][k];
    }
  }
  for (std::size_t i = 0; i < size_; ++i) {
    weights[i] = m[i][n] / m[i][i];
    if (!std::isfinite(weights[i])) return false;
  }
  return true;
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

}  // namespace stickslip
