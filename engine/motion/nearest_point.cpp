// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_point.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip {

// The weights solve Lagrange's system: the Gram matrix G of the points, bordered by ones,
// against (0, ..., 0, 1). Of few coordinates that is solved with pivots.
template <class Point>
bool NearestPointOf<Point>::minimum_with_pivots(std::array<double, kMost>& weights) const {
  constexpr int kRows = static_cast<int>(kMost) + 1;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kRows, kRows>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kRows, 1>;
  const auto used = static_cast<Eigen::Index>(size_);
  Matrix m = Matrix::Ones(used + 1, used + 1);
  m(used, used) = 0;
  for (Eigen::Index j = 0; j < used; ++j) {
    for (Eigen::Index k = 0; k < used; ++k) {
      m(j, k) = products_[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
    }
  }
  const Vector solution = m.partialPivLu().solve(Vector(Vector::Unit(used + 1, used)));
  std::copy_n(solution.data(), size_, weights.begin());
  return solution.allFinite();
}

// Of many coordinates a factor is kept, so that a point that is added costs one row of it. If
// G u = (1, ..., 1), the weights are a multiple of u. G is singular where the affine hull
// contains the origin. G plus a number at all entries is not, and has the same solution but for
// a factor (Wolfe, as above).
template <class Point>
bool NearestPointOf<Point>::affine_minimum(std::array<double, kMost>& weights) const {
  if (has_few_coordinates()) return minimum_with_pivots(weights);
  double sum = 0;
  for (std::size_t k = size_; k-- > 0;) {
    double entry = halfway_[k];
    for (std::size_t j = k + 1; j < size_; ++j) entry -= factor_[j][k] * weights[j];
    weights[k] = entry * factor_[k][k];
    sum += weights[k];
  }
  for (std::size_t k = 0; k < size_; ++k) weights[k] /= sum;
  return std::all_of(weights.begin(), weights.begin() + static_cast<std::ptrdiff_t>(size_),
                     [](double weight) { return std::isfinite(weight); });
}

template <class Point>
void NearestPointOf<Point>::factorize_from(std::size_t first) {
  if (has_few_coordinates()) return;
  for (std::size_t i = first; i < size_; ++i) {
    double square = products_[i][i];
    double rest = 1;
    for (std::size_t j = 0; j < i; ++j) {
      double entry = products_[i][j];
      for (std::size_t k = 0; k < j; ++k) entry -= factor_[i][k] * factor_[j][k];
      entry *= factor_[j][j];
      factor_[i][j] = entry;
      square -= entry * entry;
      rest -= entry * halfway_[j];
    }
    factor_[i][i] = 1 / std::sqrt(square);
    halfway_[i] = rest * factor_[i][i];
  }
}

template <class Point>
void NearestPointOf<Point>::remove(std::size_t k) {
  --size_;
  for (std::size_t j = 0; j < size_; ++j) {
    products_[k][j] = products_[j][k] = products_[size_][j];
  }
  products_[k][k] = products_[size_][size_];
  points_[k] = points_[size_];
  weight_[k] = weight_[size_];
  order_[k] = order_[size_];
  factorize_from(k);
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
  if (size_ == 0 && !has_few_coordinates()) shift_ = dot(point, point);
  for (std::size_t k = 0; k <= size_; ++k) {
    products_[size_][k] = products_[k][size_] = dot(points_[k], point) + shift_;
  }
  ++size_;
  factorize_from(size_ - 1);
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
