// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The point of least norm in the convex hull of points of R^n, kept as a combination of at
/// most n + 1 of them: Wolfe's algorithm (Math. Programming 11, 1976), in double precision. It
/// only proposes; what it finds is judged elsewhere.
#pragma once

#include <array>
#include <cstddef>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip::equilibrium_detail {

/// A point or direction in double precision.
using Double3 = std::array<double, 3>;

/// The hull of the points added so far, by at most n + 1 of them.
template <std::size_t n>
class NearestPointIn {
 public:
  /// A point.
  using Point = std::array<double, n>;

  /// Adds a point and moves to the nearest point of the hull of the points now in use. Returns
  /// false if rounding left no progress.
  bool add(const Point& point);

  const Point& nearest() const { return nearest_; }  ///< the point of least norm
  std::size_t size() const { return size_; }         ///< number of points in use
  /// The points in use, by the order number of their addition (from 0), and their weights.
  /// \{ Of the k-th of them.
  std::size_t order(std::size_t k) const { return order_[k]; }
  double weight(std::size_t k) const { return weight_[k]; }
  /// \}

 private:
  /// Weights of sum 1, of any sign, of the point of least norm in the affine hull.
  bool affine_minimum(std::array<double, n + 1>& weights) const;
  void remove(std::size_t k);
  void update_nearest();

  std::array<Point, n + 1> points_{};
  std::array<double, n + 1> weight_{};
  std::array<std::size_t, n + 1> order_{};
  std::size_t size_ = 0;
  std::size_t added_ = 0;
  Point nearest_{};
};

extern template class NearestPointIn<3>;
extern template class NearestPointIn<6>;

}  // namespace stickslip::equilibrium_detail
