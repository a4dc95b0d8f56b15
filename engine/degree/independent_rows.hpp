// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Vectors chosen one after another, each of which adds a dimension; for proposals of walls.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/engine/reals.hpp"

namespace stickslip::degree_detail {

/// An orthonormal basis of the vectors that were taken so far.
class IndependentRows {
 public:
  /// Begins without vectors, in so many dimensions.
  explicit IndependentRows(Eigen::Index dimension) : dimension_(dimension) {}

  /// Returns the part of v that is new.
  Reals beyond(Reals v) const {
    for (const Reals& b : basis_) v -= b.dot(v) * b;
    return v;
  }
  /// Adds a direction, which has to be new.
  void take(const Reals& row) { basis_.push_back(beyond(row).normalized()); }
  /// Takes the best candidate and returns its index. Candidates have members `row` and `spare`;
  /// the best has the most spare times what is new of its row, if that is more than the part
  /// `least` of the row.
  template <class Candidate>
  std::optional<std::size_t> take_best(const std::vector<Candidate>& candidates, double least) {
    double best = 0;
    std::optional<std::size_t> chosen;
    for (std::size_t k = 0; k < candidates.size() && !is_full(); ++k) {
      const double rest = beyond(candidates[k].row).norm();
      if (rest <= least * candidates[k].row.norm()) continue;
      if (candidates[k].spare * rest > best) {
        best = candidates[k].spare * rest;
        chosen = k;
      }
    }
    if (chosen) take(candidates[*chosen].row);
    return chosen;
  }
  /// Returns orthonormal vectors across all that were taken, by columns.
  Eigen::MatrixXd complement() const {
    IndependentRows all = *this;
    while (!all.is_full()) {
      Reals best = Reals::Zero(dimension_);
      for (Eigen::Index k = 0; k < dimension_; ++k) {
        const Reals rest = all.beyond(Reals::Unit(dimension_, k));
        if (rest.norm() > best.norm()) best = rest;
      }
      all.basis_.push_back(best.normalized());
    }
    const std::size_t taken = basis_.size();
    Eigen::MatrixXd result(dimension_, dimension_ - static_cast<Eigen::Index>(taken));
    for (std::size_t k = taken; k < all.basis_.size(); ++k) {
      result.col(static_cast<Eigen::Index>(k - taken)) = all.basis_[k];
    }
    return result;
  }

 private:
  bool is_full() const { return static_cast<Eigen::Index>(basis_.size()) == dimension_; }

  Eigen::Index dimension_;
  std::vector<Reals> basis_;
};

}  // namespace stickslip::degree_detail
