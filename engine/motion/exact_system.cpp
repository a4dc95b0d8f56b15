// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/exact_system.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {

namespace {

/// Elimination with complete pivoting: a, with rows and columns in another order, is L U. U is
/// kept, and what L did to a right-hand side. The pivots decide which of several solutions and
/// bases are found: the largest entry is always taken, and of equals the first by columns.
class Elimination {
 public:
  /// `b`, if it is not empty, takes part as one more column.
  Elimination(RationalMatrix a, RationalRow b)
      : a_(std::move(a)), b_(std::move(b)), order_(a_.columns()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    while (rank_ < std::min(a_.rows(), a_.columns()) && take_pivot()) ++rank_;
  }

  std::size_t rank() const { return rank_; }

  /// Returns the x with a x = b whose entries behind the pivots' are 0, or nothing if there is
  /// no solution.
  std::optional<RationalRow> solution() const {
    for (std::size_t j = rank_; j < b_.size(); ++j) {
      if (!b_[j].is_zero()) return std::nullopt;
    }
    RationalRow pivots(b_.begin(), b_.begin() + static_cast<std::ptrdiff_t>(rank_));
    return in_place(substituted(std::move(pivots)));
  }

  /// Returns the basis vector that is 1 at column `free`, behind the pivots', and 0 at the
  /// others there.
  RationalRow null_vector(std::size_t free) const {
    RationalRow pivots;
    for (std::size_t j = 0; j < rank_; ++j) pivots.push_back(-a_(j, free));
    RationalRow result = in_place(substituted(std::move(pivots)));
    result[order_[free]] = 1;
    return result;
  }

 private:
  /// Takes the next pivot; returns false if all that is left is 0.
  bool take_pivot() {
    std::size_t row = rank_;
    std::size_t column = rank_;
    Rational largest = 0;
    for (std::size_t k = rank_; k < a_.columns(); ++k) {
      for (std::size_t j = rank_; j < a_.rows(); ++j) {
        if (a_(j, k).is_zero()) continue;
        Rational size = abs(a_(j, k));
        if (size <= largest) continue;
        largest = std::move(size);
        row = j;
        column = k;
      }
    }
    if (largest.is_zero()) return false;
    exchange(row, column);
    const Rational& pivot = a_(rank_, rank_);
    for (std::size_t j = rank_ + 1; j < a_.rows(); ++j) {
      if (a_(j, rank_).is_zero()) continue;
      const Rational factor = a_(j, rank_) / pivot;
      for (std::size_t k = rank_ + 1; k < a_.columns(); ++k) {
        if (!a_(rank_, k).is_zero()) a_(j, k) -= factor * a_(rank_, k);
      }
      if (!b_.empty()) b_[j] -= factor * b_[rank_];
    }
    return true;
  }

  void exchange(std::size_t row, std::size_t column) {
    if (row != rank_) {
      for (std::size_t k = 0; k < a_.columns(); ++k) swap(a_(row, k), a_(rank_, k));
      if (!b_.empty()) swap(b_[row], b_[rank_]);
    }
    if (column == rank_) return;
    for (std::size_t j = 0; j < a_.rows(); ++j) swap(a_(j, column), a_(j, rank_));
    std::swap(order_[column], order_[rank_]);
  }

  /// Returns the y with U y = b, for the pivots' rows and columns.
  RationalRow substituted(RationalRow b) const {
    for (std::size_t j = rank_; j-- > 0;) {
      for (std::size_t k = j + 1; k < rank_; ++k) b[j] -= a_(j, k) * b[k];
      b[j] /= a_(j, j);
    }
    return b;
  }

  /// Returns the entries of the pivots' columns at the places where these stood, and 0
  /// elsewhere.
  RationalRow in_place(RationalRow pivots) const {
    RationalRow result(a_.columns());
    for (std::size_t k = 0; k < rank_; ++k) result[order_[k]] = std::move(pivots[k]);
    return result;
  }

  RationalMatrix a_;
  RationalRow b_;
  std::vector<std::size_t> order_;  ///< the place where each column stood
  std::size_t rank_ = 0;
};

}  // namespace

RationalMatrix matrix_of(const std::vector<RationalRow>& rows, std::size_t columns) {
  RationalMatrix a(rows.size(), columns);
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t k = 0; k < columns; ++k) a(j, k) = rows[j][k];
  }
  return a;
}

RationalMatrix matrix_of_columns(const std::vector<RationalRow>& columns, std::size_t rows) {
  RationalMatrix a(rows, columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    for (std::size_t j = 0; j < rows; ++j) a(j, k) = columns[k][j];
  }
  return a;
}

RationalRow operator*(const RationalMatrix& a, const RationalRow& x) {
  require(a.columns() == x.size(), "a matrix and a row fit");
  RationalRow result(a.rows());
  for (std::size_t j = 0; j < a.rows(); ++j) {
    for (std::size_t k = 0; k < a.columns(); ++k) result[j] += a(j, k) * x[k];
  }
  return result;
}

void add_multiple(RationalRow& to, const Rational& factor, const RationalRow& row) {
  require(to.size() == row.size(), "rows of one length");
  for (std::size_t j = 0; j < to.size(); ++j) to[j] += factor * row[j];
}

std::size_t rank_of(const RationalMatrix& a) {
  return Elimination(a, {}).rank();
}

std::size_t rank_of(const std::vector<RationalRow>& rows) {
  return rows.empty() ? 0 : rank_of(matrix_of(rows, rows.front().size()));
}

bool has_rank(const DegreeProof& proof, std::size_t rank) {
  return rank_of(proof.walls) == rank && rank_of(proof.direction) == rank;
}

std::vector<RationalRow> null_space(const RationalMatrix& a) {
  const Elimination eliminated(a, {});
  std::vector<RationalRow> basis;
  for (std::size_t k = eliminated.rank(); k < a.columns(); ++k) {
    basis.push_back(eliminated.null_vector(k));
  }
  return basis;
}

std::optional<RationalRow> solve_exactly(const RationalMatrix& a, const RationalRow& b,
                                         bool only_one) {
  require(a.rows() == b.size(), "a system has as many rows as right-hand sides");
  const Elimination eliminated(a, b);
  if (only_one && eliminated.rank() < a.columns()) return std::nullopt;
  return eliminated.solution();
}

}  // namespace stickslip
