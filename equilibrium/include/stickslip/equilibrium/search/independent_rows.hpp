// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Vectors of which each adds a dimension, chosen one after another; for proposals of walls.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace stickslip::equilibrium_detail {

/// An orthonormal basis of what was taken so far.
template <int D>
class IndependentRows {
 public:
  /// Of D coordinates.
  using Row = Eigen::Matrix<double, D, 1>;

  /// The part of v that is new.
  Row beyond(Row v) const {
    for (const Row& b : basis_) v -= b.dot(v) * b;
    return v;
  }
  /// Adds a direction; one that is new.
  void take(const Row& row) { basis_.push_back(beyond(row).normalized()); }
  std::size_t size() const { return basis_.size(); }  ///< how many were taken
  /// Of candidates, which have members `row` and `spare`, the one with most spare times what is
  /// new of its row, if that is more than the part `least` of it; it is taken.
  template <class Candidate>
  std::optional<std::size_t> take_best(const std::vector<Candidate>& candidates, double least) {
    double best = 0;
    std::optional<std::size_t> chosen;
    for (std::size_t k = 0; k < candidates.size() && basis_.size() < D; ++k) {
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
  /// Orthonormal vectors across all that were taken, by columns.
  Eigen::MatrixXd complement() const {
    IndependentRows all = *this;
    while (all.basis_.size() < D) {
      Row best = Row::Zero();
      for (Eigen::Index k = 0; k < D; ++k) {
        const Row rest = all.beyond(Row::Unit(k));
        if (rest.norm() > best.norm()) best = rest;
      }
      all.basis_.push_back(best.normalized());
    }
    Eigen::MatrixXd result(D, static_cast<Eigen::Index>(D - basis_.size()));
    for (std::size_t k = basis_.size(); k < D; ++k) {
      result.col(static_cast<Eigen::Index>(k - basis_.size())) = all.basis_[k];
    }
    return result;
  }

 private:
  std::vector<Row> basis_;
};

}  // namespace stickslip::equilibrium_detail
