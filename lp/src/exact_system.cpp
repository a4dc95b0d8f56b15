// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/lp/exact_system.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {

namespace {

/// Elimination with complete pivoting on integers: row j of (a, b) is multiplied by scale_j,
/// the least that leaves no fractions. After r pivots an entry is the minor of the pivots' rows
/// and columns and its own, so that the division by the pivot before has no remainder (Bareiss,
/// "Sylvester's identity and multistep integer-preserving Gaussian elimination", 1968).
///
/// The pivots decide which of several solutions and bases are found: the entry that is largest
/// where rows are not multiplied is always taken, and of equals the first by columns.
class Elimination {
 public:
  /// `b`, if it is not empty, takes part as one more column.
  Elimination(const RationalMatrix& a, const RationalRow& b)
      : rows_(a.rows()), columns_(a.columns()), has_right_side_(!b.empty()), order_(columns_) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    entries_.resize(rows_ * width());
    for (std::size_t j = 0; j < rows_; ++j) {
      const auto entry = [&](std::size_t k) -> const Rational& {
        return k < columns_ ? a(j, k) : b[j];
      };
      Integer& scale = scales_.emplace_back(1);
      for (std::size_t k = 0; k < width(); ++k) {
        if (entry(k).is_integer()) continue;
        mpz_lcm(scale.mutable_gmp(), scale.gmp(), denominator(entry(k)).gmp());
      }
      for (std::size_t k = 0; k < width(); ++k) {
        if (!entry(k).is_zero()) at(j, k) = numerator(Rational(entry(k) * Rational(scale)));
      }
    }
    Integer before = 1;
    while (rank_ < std::min(rows_, columns_) && take_pivot(before)) ++rank_;
  }

  std::size_t rank() const { return rank_; }

  /// Returns the x with a x = b whose entries behind the pivots' are 0, or nothing if there is
  /// no solution.
  std::optional<RationalRow> solution() const {
    for (std::size_t j = rank_; has_right_side_ && j < rows_; ++j) {
      if (!at(j, columns_).is_zero()) return std::nullopt;
    }
    return in_place(substituted(columns_, 1));
  }

  /// Returns the basis vector that is 1 at column `free`, behind the pivots', and 0 at the
  /// others there.
  RationalRow null_vector(std::size_t free) const {
    RationalRow result = in_place(substituted(free, -1));
    result[order_[free]] = 1;
    return result;
  }

 private:
  std::size_t width() const { return columns_ + (has_right_side_ ? 1 : 0); }
  Integer& at(std::size_t j, std::size_t k) { return entries_[j * width() + k]; }
  const Integer& at(std::size_t j, std::size_t k) const { return entries_[j * width() + k]; }

  /// Returns whether |at(j, k)| / scale_j > |at(row, column)| / scale_row. Numbers of bits
  /// decide where they differ by enough.
  bool is_larger(std::size_t j, std::size_t k, std::size_t row, std::size_t column) const {
    if (at(row, column).is_zero()) return !at(j, k).is_zero();
    if (scales_[j] == scales_[row]) {
      return mpz_cmpabs(at(j, k).gmp(), at(row, column).gmp()) > 0;
    }
    const auto bits = [](const Integer& x) { return mpz_sizeinbase(x.gmp(), 2); };
    const std::size_t ours = bits(at(j, k)) + bits(scales_[row]);
    const std::size_t theirs = bits(at(row, column)) + bits(scales_[j]);
    if (ours > theirs + 1) return true;
    if (ours + 1 < theirs) return false;
    const Integer product = at(j, k) * scales_[row];
    const Integer other = at(row, column) * scales_[j];
    return mpz_cmpabs(product.gmp(), other.gmp()) > 0;
  }

  /// Takes the next pivot, and puts it into `before`, which is the one before it; returns false
  /// if all that is left is 0.
  bool take_pivot(Integer& before) {
    std::size_t row = rank_;
    std::size_t column = rank_;
    for (std::size_t k = rank_; k < columns_; ++k) {
      for (std::size_t j = rank_; j < rows_; ++j) {
        if (at(j, k).is_zero() || !is_larger(j, k, row, column)) continue;
        row = j;
        column = k;
      }
    }
    if (at(row, column).is_zero()) return false;
    exchange(row, column);
    const Integer& pivot = at(rank_, rank_);
    for (std::size_t j = rank_ + 1; j < rows_; ++j) {
      const Integer& factor = at(j, rank_);
      if (factor.is_zero() && pivot == before) continue;  // it stays as it is
      for (std::size_t k = rank_ + 1; k < width(); ++k) {
        mpz_ptr entry = at(j, k).mutable_gmp();
        mpz_mul(entry, entry, pivot.gmp());
        if (!factor.is_zero() && !at(rank_, k).is_zero()) {
          mpz_submul(entry, factor.gmp(), at(rank_, k).gmp());
        }
        mpz_divexact(entry, entry, before.gmp());
      }
    }
    before = pivot;
    return true;
  }

  void exchange(std::size_t row, std::size_t column) {
    if (row != rank_) {
      for (std::size_t k = 0; k < width(); ++k) swap(at(row, k), at(rank_, k));
      swap(scales_[row], scales_[rank_]);
    }
    if (column == rank_) return;
    for (std::size_t j = 0; j < rows_; ++j) swap(at(j, column), at(j, rank_));
    std::swap(order_[column], order_[rank_]);
  }

  /// Returns the y with U y = sign b, for the pivots' rows and columns, where b is a column.
  RationalRow substituted(std::size_t column, int sign) const {
    RationalRow y(rank_);
    for (std::size_t j = rank_; j-- > 0;) {
      y[j] = Rational(at(j, column)) * sign;
      for (std::size_t k = j + 1; k < rank_; ++k) y[j] -= Rational(at(j, k)) * y[k];
      y[j] /= Rational(at(j, j));
    }
    return y;
  }

  /// Returns the entries of the pivots' columns at the places where these stood, and 0
  /// elsewhere.
  RationalRow in_place(RationalRow pivots) const {
    RationalRow result(columns_);
    for (std::size_t k = 0; k < rank_; ++k) result[order_[k]] = std::move(pivots[k]);
    return result;
  }

  std::size_t rows_;
  std::size_t columns_;
  bool has_right_side_;
  std::vector<Integer> scales_;     ///< the number that each row was multiplied by
  std::vector<Integer> entries_;    ///< one row after another
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
