// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact linear algebra over the rationals, by elimination without fractions (Bareiss, 1968).
/// An n x n system takes O(n^3) operations on numbers that grow to n times their length.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/core/row.hpp"

namespace stickslip {

/// A matrix of any size. It holds zeros until entries are set.
class RationalMatrix {
 public:
  RationalMatrix() = default;
  /// Makes a matrix of zeros.
  RationalMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), entries_(rows * columns) {}

  std::size_t rows() const { return rows_; }        ///< the number of rows
  std::size_t columns() const { return columns_; }  ///< the number of columns
  /// \{ Returns the entry in this row and column, both counted from 0.
  Rational& operator()(std::size_t row, std::size_t column) {
    return entries_[row * columns_ + column];
  }
  const Rational& operator()(std::size_t row, std::size_t column) const {
    return entries_[row * columns_ + column];
  }
  /// \}

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::vector<Rational> entries_;  ///< one row after another
};

/// Returns the matrix with these rows, each of `columns` entries.
RationalMatrix matrix_of(const std::vector<RationalRow>& rows, std::size_t columns);
/// Returns the matrix with these columns, each of `rows` entries.
RationalMatrix matrix_of_columns(const std::vector<RationalRow>& columns, std::size_t rows);

/// Returns a x. Requires that x has as many entries as a has columns.
RationalRow operator*(const RationalMatrix& a, const RationalRow& x);
/// Adds `factor` times a row to another of the same length.
void add_multiple(RationalRow& to, const Rational& factor, const RationalRow& row);

/// \{ Returns the rank of a matrix, or of a list of rows of one length.
std::size_t rank_of(const RationalMatrix& a);
std::size_t rank_of(const std::vector<RationalRow>& rows);
/// \}
/// Returns a basis of the solutions of a x = 0, which are all x if a has no rows.
std::vector<RationalRow> null_space(const RationalMatrix& a);

/// Returns a solution of a x = b; nothing if there is none or if, with `only_one`, there are
/// several.
std::optional<RationalRow> solve_exactly(const RationalMatrix& a, const RationalRow& b,
                                         bool only_one = false);

}  // namespace stickslip
