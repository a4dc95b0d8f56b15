// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The point of least norm in the convex hull of points of R^n, kept as a combination of at
/// most n + 1 of them: Wolfe's algorithm (Math. Programming 11, 1976), in double precision. It
/// only proposes; what it finds is judged elsewhere.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "stickslip/engine/reals.hpp"

namespace stickslip {

/// A point or direction in double precision.
using Double3 = std::array<double, 3>;

/// \{ How many points a hull may use: one more than there are coordinates.
template <class Point>
constexpr std::size_t kMostPointsOf = std::tuple_size_v<Point> + 1;
template <>
inline constexpr std::size_t kMostPointsOf<Reals> = kMostCoordinates + 1;
/// \}

/// The hull of the points added so far, by at most n + 1 of them. A Point is a std::array of n
/// doubles, or Reals.
template <class Point>
class NearestPointOf {
 public:
  /// Adds a point and moves to the nearest point of the hull of the points now in use. Returns
  /// false if rounding left no progress.
  bool add(const Point& point);

  const Point& nearest() const { return nearest_; }  ///< the point of least norm
  std::size_t size() const { return size_; }         ///< number of points in use
  /// \{ Returns the order number of addition (from 0), or the weight, of the k-th point in use.
  std::size_t order(std::size_t k) const { return order_[k]; }
  double weight(std::size_t k) const { return weight_[k]; }
  /// \}

 private:
  static constexpr std::size_t kMost = kMostPointsOf<Point>;
  static constexpr std::size_t kFewCoordinates = 12;

  /// Finds weights of sum 1, of any sign, of the point of least norm in the affine hull.
  /// Returns false if they are not finite.
  bool affine_minimum(std::array<double, kMost>& weights) const;
  bool minimum_with_pivots(std::array<double, kMost>& weights) const;
  bool has_few_coordinates() const {
    return static_cast<std::size_t>(points_[0].size()) <= kFewCoordinates;
  }
  /// Computes the rows of the factor from this one on.
  void factorize_from(std::size_t first);
  void remove(std::size_t k);
  void update_nearest();

  std::array<Point, kMost> points_{};
  /// The products of two points, and a common number more.
  std::array<std::array<double, kMost>, kMost> products_;
  /// The lower triangle L with L L' = products_; its diagonal is inverted.
  std::array<std::array<double, kMost>, kMost> factor_;
  std::array<double, kMost> halfway_;  ///< The solution h of L h = (1, ..., 1).
  double shift_ = 0;                   ///< The common number, which makes the matrix definite.
  std::array<double, kMost> weight_{};
  std::array<std::size_t, kMost> order_{};
  std::size_t size_ = 0;
  std::size_t added_ = 0;
  Point nearest_{};
};

extern template class NearestPointOf<Double3>;
extern template class NearestPointOf<std::array<double, 6>>;
extern template class NearestPointOf<Reals>;

}  // namespace stickslip
