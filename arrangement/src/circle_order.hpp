// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The points where one great circle crosses the others, in the order in which they are
/// passed, exactly.
///
/// Circle i is passed counterclockwise about n_i. It meets circle j in the two antipodal
/// points +-(n_i x n_j); at +n_i x n_j the sign of n_j changes from + to -, because the
/// direction of travel n_i x (n_i x n_j) has the negative product
/// (n_i.n_j)^2 - |n_i|^2 |n_j|^2 with n_j.
///
/// So half of the circle is sorted and the other half is its mirror image. The half starts in
/// the point n_i x n_r, where r is the lowest circle other than i. On it circle j is crossed
/// once, at side(j) * (n_i x n_j), where its sign changes from side(j) to -side(j). At the
/// start every circle j that does not pass through it has the sign side(j) = sign
/// det(n_i, n_r, n_j), and the point of j comes before that of k iff
/// side(j) side(k) det(n_i, n_j, n_k) > 0. Points are equal iff that is 0.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "filtered_normals.hpp"
#include "stickslip/core/cancellation.hpp"

namespace stickslip::arrangement_detail {

/// The order of the crossings on a circle, for one circle after the other. Each thread has one
/// of its own, in which everything is allocated once.
class CircleOrder {
 public:
  /// Makes an order. Requires at least two circles, at most kMaxCircles.
  explicit CircleOrder(const FilteredNormals& normals);

  static constexpr std::size_t kMaxCircles = std::size_t{1} << 20;

  /// Computes the order on circle i. O(k log k) exact signs, whatever the doubles say.
  void sort(std::size_t i);

  /// All following functions are about the circle sorted last.

  /// Returns the number h of points on half the circle; after them come their antipodes.
  std::size_t half_points() const { return point_begin_.size() - 1; }

  /// Iterates over the other circles through point q < h.
  const std::uint32_t* begin(std::size_t q) const { return order_.data() + point_begin_[q]; }
  const std::uint32_t* end(std::size_t q) const { return order_.data() + point_begin_[q + 1]; }
  /// Returns how many circles pass through point q, this one included.
  std::size_t multiplicity(std::size_t q) const {
    return point_begin_[q + 1] - point_begin_[q] + 1;
  }

  /// Returns whether no circle through point q has a lower number than this one.
  bool is_lowest(std::size_t q) const {
    return std::all_of(begin(q), end(q), [this](std::uint32_t j) { return j > circle_; });
  }

  /// Returns +1 or -1, the sign of circle j before it is crossed on the first half.
  int side(std::size_t j) const { return side_[j]; }

  /// Returns all circles through point q < h, this one included, by the slope of their
  /// counterclockwise directions there: a comes before b iff n_a x n_b is a positive multiple
  /// of the point. At the antipode the order is the reverse. The result is valid until the next
  /// call.
  const std::vector<std::uint32_t>& by_slope(std::size_t q);

  SweepWork& work() { return signs_.work(); }

 private:
  void set_sides();
  void set_side_at_start(std::size_t j);
  void sort_by_key();
  bool cut_into_points();
  void repair();
  Sign compare(std::uint32_t a, std::uint32_t b);

  const FilteredNormals* normals_;
  ExactSigns signs_;
  std::size_t circle_ = 0;
  std::size_t reference_ = 0;           ///< r
  std::size_t start_axis_ = 0;          ///< a coordinate of n_i x n_r that is not 0
  Sign start_axis_sign_ = Sign::kZero;  ///< the sign of that coordinate
  std::vector<double> x_, y_;  ///< the point of circle j, in a frame of the circle's plane
  std::vector<std::int8_t> side_;
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> point_begin_;
  std::vector<std::uint32_t> slopes_;
};

/// Runs a loop over the circles on several threads. Calls work(scratch, i) for i < count, where
/// each thread has a scratch of its own, made by make(). Then calls finish(scratch) for each of
/// them, on this thread and in no particular order, so that these calls must commute. `threads`
/// = 0 takes all that the machine has, and with 1 everything happens on this thread, in order.
template <class Make, class Work, class Finish>
void over_circles(std::size_t count, unsigned threads, Make make, Work work, Finish finish) {
  if (threads == 1 || count < 2) {
    auto scratch = make();
    for (std::size_t i = 0; i < count; ++i) {
      throw_if_cancelled();
      work(scratch, i);
    }
    finish(scratch);
    return;
  }
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
  Cancellation* const cancellation = Cancellation::current();
  arena.execute([&] {
    tbb::enumerable_thread_specific<decltype(make())> scratches(make);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        const SharedCancellation shared(cancellation);
                        auto& scratch = scratches.local();
                        for (std::size_t i = range.begin(); i != range.end(); ++i) {
                          throw_if_cancelled();
                          work(scratch, i);
                        }
                      });
    for (auto& scratch : scratches) finish(scratch);
  });
}

}  // namespace stickslip::arrangement_detail
