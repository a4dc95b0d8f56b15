// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_point.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip {

template <class Point>
bool NearestPointOf<Point>::affine_minimum(std::array<double, kMost>& weights) const {
  // The weights solve Lagrange's system: the Gram matrix of the points, bordered by ones,
  // against (0, ..., 0, 1).
  constexpr int kRows = static_cast<int>(kMost) + 1;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kRows, kRows>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kRows, 1>;
  const auto used = static_cast<Eigen::Index>(size_);
  Matrix m = Matrix::Ones(used + 1, used + 1);
  m(used, used) = 0;
  m.topLeftCorner(used, used) = products_.topLeftCorner(used, used);
  const Vector solution = m.partialPivLu().solve(Vector(Vector::Unit(used + 1, used)));
  std::copy_n(solution.data(), size_, weights.begin());
  return solution.allFinite();
}

/// Fills in the products of the last point in use.
template <class Point>
void NearestPointOf<Point>::multiply_last() {
  const auto last = static_cast<Eigen::Index>(size_) - 1;
  for (std::size_t k = 0; k < size_; ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    products_(at, last) = products_(last, at) = dot(points_[k], points_[size_ - 1]);
  }
}

template <class Point>
void NearestPointOf<Point>::remove(std::size_t k) {
  --size_;
  const auto last = static_cast<Eigen::Index>(size_);
  const auto at = static_cast<Eigen::Index>(k);
  products_.row(at).head(last + 1) = products_.row(last).head(last + 1);
  products_.col(at).head(last + 1) = products_.col(last).head(last + 1);
  points_[k] = points_[size_];
  weight_[k] = weight_[size_];
  order_[k] = order_[size_];
}

template <class Point>
void NearestPointOf<Point>::update_nearest() {
  for (auto& entry : nearest_) entry = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    std::size_t j = 0;
    for (auto& entry : nearest_) entry += weight_[k] * points_[k][j++];
  }
}

template <class Point>
bool NearestPointOf<Point>::add(const Point& point) {
  if (size_ > static_cast<std::size_t>(point.size())) return false;  // the origin is inside
  if (added_ == 0) nearest_ = point;
  points_[size_] = point;
  weight_[size_] = size_ == 0 ? 1.0 : 0.0;
  order_[size_] = added_++;
  ++size_;
  multiply_last();
  const bool first = size_ == 1;
  const double before = dot(nearest_, nearest_);
  // Each pass removes a point, so there are at most n + 1.
  while (true) {
    std::array<double, kMost> target{};
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

template class NearestPointOf<Double3>;
template class NearestPointOf<std::array<double, 6>>;
template class NearestPointOf<Reals>;

Row in_bits(const Reals& a, int bits) {
  Row result(static_cast<std::size_t>(a.size()));
  const double largest = a.size() > 0 ? a.lpNorm<Eigen::Infinity>() : 0;
  if (!a.allFinite() || !(largest > 0)) return result;
  for (std::size_t j = 0; j < result.size(); ++j) {
    result[j] = std::llround(std::ldexp(a[static_cast<Eigen::Index>(j)] / largest, bits));
  }
  return primitive(std::move(result));
}

}  // namespace stickslip
