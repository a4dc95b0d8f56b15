// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter. With u = n_i x n_r and a = u x n_i, let y_j = u.n_j and x_j = a.n_j. Then
//   y_j = det(n_i, n_r, n_j),
//   x_j y_k - x_k y_j = (a x u).(n_j x n_k) = |u|^2 det(n_i, n_j, n_k),
// because a x u = |u|^2 n_i (u is orthogonal to n_i). Both signs are wanted, so two inner
// products for each circle and one 2x2 determinant for each pair serve. Also (x_j, y_j) are,
// up to positive factors, the coordinates of n_i x n_j along u and n_i x u: its angle.
//
// Errors, with e = 2^-53, in any rounding mode: one rounding is at most the unit in the last
// place. The entries of n and u (the cross product is computed exactly, then rounded) are at
// most 1 and within e.
//   y: a product of entries is within 2e and its rounding adds e; three of them 9e; the sums
//      are at most 2 and 3 in size, so their roundings add 2e and 4e. Below 16e. |y| <= 3.
//   a: two products 6e, and 2e. 8e. |a| <= 2 in each entry.
//   x: a product is within 2e + 8e, and 2e; three of them 36e; the sums are at most 4 and 6 in
//      size and add 4e and 8e. 48e. |x| <= 6.
//   x_j y_k - x_k y_j: a product is within 6 * 16e + 3 * 48e = 240e, and its rounding (size at
//      most 18) 32e; two of them 544e, and the difference (at most 36) adds 64e. 608e, which
//      leaves 32e of the bound for the terms of second order and for underflow.
// Contracting a product and a sum into one operation only leaves out roundings.
#include "circle_order.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/core/error.hpp"

namespace stickslip::arrangement_detail {
namespace {

constexpr double kUnit = 0x1p-53;
constexpr double kSideBound = 16 * kUnit;
constexpr double kOrderBound = 640 * kUnit;

// A sort key has the angle in steps of 2^-43 above the number of the circle.
constexpr unsigned kCircleBits = 20;
constexpr double kAngleSteps = 0x1p42;
static_assert(CircleOrder::kMaxCircles == std::size_t{1} << kCircleBits);

/// Returns a number in [0, 2] that grows with the angle from 0 to pi. Requires y >= 0.
double pseudo_angle(double x, double y) {
  const double size = std::abs(x) + y;
  return size > 0 ? 1 - x / size : 1;
}

}  // namespace

CircleOrder::CircleOrder(const FilteredNormals& normals)
    : normals_(&normals),
      signs_(normals),
      x_(normals.size()),
      y_(normals.size()),
      side_(normals.size()) {
  require(normals.size() >= 2 && normals.size() <= kMaxCircles,
          "sweep: the number of circles is out of range");
  keys_.reserve(normals.size());
  order_.reserve(normals.size());
  point_begin_.reserve(normals.size() + 1);
  slopes_.reserve(normals.size());
}

void CircleOrder::sort(std::size_t i) {
  circle_ = i;
  reference_ = i == 0 ? 1 : 0;
  start_axis_sign_ = Sign::kZero;
  for (std::size_t c = 0; start_axis_sign_ == Sign::kZero; ++c) {
    require(c < 3, "sweep: two circles coincide");
    start_axis_ = c;
    start_axis_sign_ = signs_.cross_coordinate(i, reference_, c);
  }
  order_.clear();
  keys_.clear();
  set_sides();
  point_begin_.assign({0, static_cast<std::uint32_t>(order_.size())});
  sort_by_key();
  if (cut_into_points()) return;
  repair();
  require(cut_into_points(), "sweep: the order of crossings contradicts itself");
}

/// Finds all sides. It also puts the circles through the start into order_, and the keys of the
/// others into keys_.
void CircleOrder::set_sides() {
  const auto& n = normals_->approximate();
  const std::size_t k = normals_->size();
  const std::array<double, 3> u = signs_.cross(circle_, reference_);
  const std::array<double, 3> ni = {n[0][circle_], n[1][circle_], n[2][circle_]};
  const std::array<double, 3> a = {u[1] * ni[2] - u[2] * ni[1], u[2] * ni[0] - u[0] * ni[2],
                                   u[0] * ni[1] - u[1] * ni[0]};
  for (std::size_t j = 0; j < k; ++j) {
    y_[j] = u[0] * n[0][j] + u[1] * n[1][j] + u[2] * n[2][j];
    x_[j] = a[0] * n[0][j] + a[1] * n[1][j] + a[2] * n[2][j];
  }
  for (std::size_t j = 0; j < k; ++j) {
    if (j == circle_) continue;
    if (j == reference_) {
      side_[j] = 1;
      order_.push_back(static_cast<std::uint32_t>(j));
      continue;
    }
    Sign side = y_[j] > 0 ? Sign::kPositive : Sign::kNegative;
    if (std::abs(y_[j]) > kSideBound) {
      ++work().by_double;
    } else {
      side = signs_.determinant(circle_, reference_, j);
      if (side == Sign::kZero) {
        set_side_at_start(j);
        order_.push_back(static_cast<std::uint32_t>(j));
        continue;
      }
    }
    side_[j] = static_cast<std::int8_t>(to_int(side));
    x_[j] *= side_[j];
    y_[j] *= side_[j];
    const double angle = pseudo_angle(x_[j], std::abs(y_[j]));
    keys_.push_back((static_cast<std::uint64_t>(angle * kAngleSteps) << kCircleBits) | j);
  }
}

/// Finds the side of a circle j that passes through n_i x n_r: it is crossed there from + to -
/// iff n_i x n_j is a positive multiple.
void CircleOrder::set_side_at_start(std::size_t j) {
  const Sign sign = signs_.cross_coordinate(circle_, j, start_axis_) * start_axis_sign_;
  side_[j] = static_cast<std::int8_t>(to_int(sign));
}

void CircleOrder::sort_by_key() {
  std::sort(keys_.begin(), keys_.end());
  for (const std::uint64_t key : keys_) {
    order_.push_back(static_cast<std::uint32_t>(key & (kMaxCircles - 1)));
  }
}

/// Confirms every adjacent pair. Returns false as soon as one is in the wrong order.
bool CircleOrder::cut_into_points() {
  point_begin_.resize(2);
  for (std::size_t p = point_begin_[1] + 1; p < order_.size(); ++p) {
    const Sign sign = compare(order_[p - 1], order_[p]);
    if (sign == Sign::kNegative) return false;
    if (sign == Sign::kPositive) point_begin_.push_back(static_cast<std::uint32_t>(p));
  }
  if (point_begin_[1] < order_.size()) {
    point_begin_.push_back(static_cast<std::uint32_t>(order_.size()));
  }
  return true;
}

/// Sorts again. An insertion sort by exact comparisons is right whatever the keys were, and
/// fast when they were nearly right. When they were not, an ordinary sort starts afresh.
void CircleOrder::repair() {
  const std::size_t first = point_begin_[1];
  std::size_t moves_left = 4 * keys_.size() + 64;
  for (std::size_t p = first + 1; p < order_.size(); ++p) {
    const std::uint32_t moved = order_[p];
    std::size_t hole = p;
    while (hole > first && compare(order_[hole - 1], moved) == Sign::kNegative) {
      order_[hole] = order_[hole - 1];
      --hole;
      --moves_left;
      if (moves_left == 0) break;
    }
    order_[hole] = moved;
    if (moves_left == 0) break;
  }
  if (moves_left > 0) return;
  ++work().exact_sorts;
  std::sort(
      order_.begin() + static_cast<std::ptrdiff_t>(first), order_.end(),
      [this](std::uint32_t a, std::uint32_t b) { return compare(a, b) == Sign::kPositive; });
}

/// Returns + if the point of a comes before that of b, and 0 if it is the same. Requires that
/// neither circle passes through the start.
Sign CircleOrder::compare(std::uint32_t a, std::uint32_t b) {
  const double determinant = x_[a] * y_[b] - x_[b] * y_[a];
  if (std::abs(determinant) > kOrderBound) {
    ++work().by_double;
    return determinant > 0 ? Sign::kPositive : Sign::kNegative;
  }
  return signs_.determinant(circle_, a, b) * sign_of_int(side_[a] * side_[b]);
}

const std::vector<std::uint32_t>& CircleOrder::by_slope(std::size_t q) {
  slopes_.assign(begin(q), end(q));
  slopes_.push_back(static_cast<std::uint32_t>(circle_));
  if (slopes_.size() == 2) {
    // The point is side(j) * (n_i x n_j).
    if (side_[slopes_[0]] > 0) std::swap(slopes_[0], slopes_[1]);
    return slopes_;
  }
  // The point as side(j) * (n_i x n_j), by the sign of one coordinate that is not 0.
  const std::uint32_t j = *begin(q);
  Sign axis_sign = Sign::kZero;
  std::size_t axis = 0;
  for (; axis < 3; ++axis) {
    axis_sign = signs_.cross_coordinate(circle_, j, axis) * sign_of_int(side_[j]);
    if (axis_sign != Sign::kZero) break;
  }
  require(axis_sign != Sign::kZero, "sweep: two circles coincide");
  std::sort(slopes_.begin(), slopes_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return a != b && signs_.cross_coordinate(a, b, axis) == axis_sign;
  });
  return slopes_;
}

}  // namespace stickslip::arrangement_detail
