// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Linear systems over the rationals, by Gaussian elimination. O(n^3) operations on numbers
/// that grow to n times their length.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/core/row.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip {

/// A matrix of any size, of zeros until entries are set.
class RationalMatrix {
 public:
  RationalMatrix() = default;
  /// A matrix of zeros.
  RationalMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), entries_(rows * columns) {}

  std::size_t rows() const { return rows_; }        ///< how many
  std::size_t columns() const { return columns_; }  ///< how many
  /// \{ An entry, by its row and column from 0.
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

/// The matrix with these rows, each of so many entries.
RationalMatrix matrix_of(const std::vector<RationalRow>& rows, std::size_t columns);
/// The same with these columns, each of so many entries.
RationalMatrix matrix_of_columns(const std::vector<RationalRow>& columns, std::size_t rows);

/// a x, for a row x of as many entries as a has columns.
RationalRow operator*(const RationalMatrix& a, const RationalRow& x);
/// Adds `factor` times a row to another of the same length.
void add_multiple(RationalRow& to, const Rational& factor, const RationalRow& row);

/// \{ The rank of a matrix, which may be given by rows of one length.
std::size_t rank_of(const RationalMatrix& a);
std::size_t rank_of(const std::vector<RationalRow>& rows);
/// \}
/// `degree-walls` and `degree-direction`: both have this rank, that of all forces.
bool has_rank(const DegreeProof& proof, std::size_t rank);

/// A basis of the x with a x = 0; of all x where a has no rows.
std::vector<RationalRow> null_space(const RationalMatrix& a);

/// A solution of a x = b; nothing if there is none or, with `only_one`, several.
std::optional<RationalRow> solve_exactly(const RationalMatrix& a, const RationalRow& b,
                                         bool only_one = false);

}  // namespace stickslip
