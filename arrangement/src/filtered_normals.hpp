// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The normals of distinct circles in three precisions, and the exact signs that the sweep
/// needs of them.
///
/// Doubles: scaled normals n^ with entries in [-1, 1], each within u = 2^-53 of a positive
/// multiple of the exact normal. They decide nothing by themselves; the error bounds of
/// circle_order.cpp start from here.
/// 64-bit integers, where the entries fit: determinants then need bits(i) + bits(j) + bits(k)
/// <= 124, since |det| <= 6 * 2^124 < 2^127; the 2x2 minors always fit, as
/// 2 * 2^(63 + 63) = 2^127 is not reached. Else GMP.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "stickslip/arrangement/great_circles.hpp"
#include "stickslip/arrangement/sweep.hpp"

namespace stickslip::arrangement_detail {

/// Returns a vector (1, s, s^2) that lies on no circle. A normal is orthogonal to that of at
/// most two s, so one of the first 2k + 1 is found. Throws ContractError if a normal is zero.
IntegerVector3 find_pole(const std::vector<IntegerVector3>& normals);

/// The normals Mn of distinct circles, in the same order, for an integer matrix M with
/// det M != 0 such that, exactly,
///   - every mapped normal has z != 0: no circle passes through a pole;
///   - every cross product of two mapped normals has y != 0: no vertex lies on the plane y = 0.
/// So an algorithm that cuts the sphere along a meridian from pole to pole, as CGAL's, meets
/// none of its special cases; and for any regular M, n.d = (Mn).(M^-T d), so the circles have
/// the same cells with the same signs. Deterministic. O(k^2) operations for each matrix tried,
/// and the first usually serves. Throws ContractError if a normal is zero or two are parallel:
/// then no matrix serves.
std::vector<IntegerVector3> in_generic_position(const std::vector<IntegerVector3>& normals);

class FilteredNormals {
 public:
  /// Takes the normals, and reverses some so that all are positive on the pole (find_pole).
  explicit FilteredNormals(std::vector<IntegerVector3> normals);

  std::size_t size() const { return exact_.size(); }

  /// Returns the normals in doubles, by coordinate and then by circle.
  const std::array<std::vector<double>, 3>& approximate() const { return approximate_; }

  const IntegerVector3& exact(std::size_t i) const { return exact_[i]; }
  /// Returns whether the pole has the sign - on the circle as it was given.
  bool is_reversed(std::size_t i) const { return reversed_[i]; }

  using Small = std::array<std::int64_t, 3>;
  const Small& small(std::size_t i) const { return small_[i]; }
  /// Returns the number of bits of the largest entry; kTooLong if some entry does not fit
  /// `small`.
  unsigned bits(std::size_t i) const { return bits_[i]; }
  static constexpr unsigned kTooLong = 1000;

 private:
  std::vector<IntegerVector3> exact_;
  std::vector<bool> reversed_;
  std::vector<Small> small_;
  std::vector<unsigned> bits_;
  std::array<std::vector<double>, 3> approximate_;
};

/// Finds exact signs, with scratch numbers that are allocated once. There is one for each
/// thread.
class ExactSigns {
 public:
  explicit ExactSigns(const FilteredNormals& normals) : normals_(&normals) {}

  /// Returns sign det(n_i, n_j, n_k).
  Sign determinant(std::size_t i, std::size_t j, std::size_t k);

  /// Returns the sign of one coordinate of n_i x n_j. It is not filtered: it is asked only
  /// where circles meet in one point, and for one coordinate of one crossing a circle.
  Sign cross_coordinate(std::size_t i, std::size_t j, std::size_t coordinate);

  /// Returns a positive multiple of n_i x n_j with entries in [-1, 1], the largest at least
  /// 1/2, each within u = 2^-53. Requires distinct circles.
  std::array<double, 3> cross(std::size_t i, std::size_t j);

  SweepWork& work() { return work_; }

 private:
  void set_minor(Integer& result, std::size_t i, std::size_t j, std::size_t coordinate);

  const FilteredNormals* normals_;
  SweepWork work_;
  Integer minor_, product_, sum_;
};

}  // namespace stickslip::arrangement_detail
