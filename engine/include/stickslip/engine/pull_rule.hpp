// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rule of list 2 of a proof by degree (certificate/FORMAT.md, section 6).
#pragma once

#include <algorithm>
#include <vector>

#include "stickslip/engine/reals.hpp"

namespace stickslip {

/// The rule `leaf-direction`, which each leaf of list 2 has to satisfy besides: y.A(d - h d0)
/// >= 0.
class PullRule {
 public:
  /// Makes the rule from A, by rows, and d0.
  PullRule(const std::vector<RationalRow>& matrix, const RationalRow& twist);
  /// Makes the rule from the rows of A(d - h d0), as functions of points.
  explicit PullRule(const std::vector<RationalRow>& rows);

  /// Returns whether the function y.A(d - h d0) is below 0 at none of the points.
  template <class Twist, class Point>
  bool holds(const Twist& y, const std::vector<Point>& points) const {
    Row function(rows_.front().size());
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      for (std::size_t k = 0; k < function.size(); ++k) function[k] += y[j] * rows_[j][k];
    }
    return std::none_of(points.begin(), points.end(),
                        [&](const Point& x) { return value(function, x).sign() < 0; });
  }
  /// Returns A(d - h d0) at a point, times one positive number that is the same for all points.
  template <class Point>
  Row at(const Point& x) const {
    Row exact;
    for (const Row& row : rows_) exact.emplace_back(value(row, x));
    return exact;
  }
  /// Returns -A(d - h d0) at a point, up to a positive factor. Only the last step is rounded,
  /// since d - h d0 may be small beside d.
  template <class Point>
  Reals against(const Point& x) const {
    return in_doubles(negated(at(x)));
  }

 private:
  template <class Point>
  static Integer value(const Row& function, const Point& x) {
    Integer sum = 0;
    for (std::size_t k = 0; k < function.size(); ++k) sum += function[k] * x[k];
    return sum;
  }

  std::vector<Row> rows_;  ///< the rows of A(d - h d0), times one positive number
};

}  // namespace stickslip
