// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact solutions of large systems of linear equations with few entries.
///
/// **Method.** Columns are eliminated modulo a prime, one after another, which chooses as many
/// rows and columns as the rank. The solution of these is found digit by digit in the base of
/// the prime, and fractions of few bits that have these digits are it. Digits only propose: a
/// solution is returned if all equations hold exactly. A solution of n numbers of b bits takes
/// O(b f) operations for an elimination that left f entries, and O(n b^2) for the digits.
///
/// Sources: Dixon, "Exact solution of linear equations using p-adic expansions", Numer. Math.
/// 40, 1982; Wang, Guy, Davenport, "P-adic reconstruction of rational numbers", 1982.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "stickslip/core/row.hpp"

namespace stickslip {

/// A vector of fractions with one denominator.
struct SharedFractions {
  Row numerators;       ///< by coordinate
  Integer denominator;  ///< > 0

  /// Returns the fractions in lowest terms.
  RationalRow row() const;
};

/// The equations A x = b, for one matrix A and any b.
class SparseSystem {
 public:
  /// Takes A by its columns, in the order in which they are preferred: one that depends on
  /// those before it is left out. (So may be, with a probability of about 1e-9, one that does
  /// not.)
  SparseSystem(std::size_t rows, const std::vector<SparseRow>& columns);

  /// Returns the indices of the columns that are not left out, increasing.
  const std::vector<std::size_t>& independent() const { return independent_; }
  /// Returns x, 0 for the columns that are left out; nothing if there is none. Requires that b
  /// has an entry for each row.
  std::optional<SharedFractions> solve(const RationalRow& b) const;

 private:
  using Entries = std::vector<std::pair<std::size_t, std::uint64_t>>;
  using IntegerEntries = std::vector<std::pair<std::size_t, Integer>>;

  bool eliminate(const IntegerEntries& column, const std::vector<std::size_t>& counts);
  std::vector<std::uint64_t> digits(const Row& left) const;
  Row left_by(const SharedFractions& x, const Row& b) const;

  std::size_t size_;                       ///< the number of columns
  RationalRow scales_;                     ///< of rows: with these factors they are integers
  std::vector<std::size_t> independent_;   ///< indices of the columns that are kept
  std::vector<IntegerEntries> columns_;    ///< the columns that are kept
  std::vector<std::size_t> pivots_;        ///< the row of each
  std::vector<std::size_t> order_of_row_;  ///< the column whose pivot the row is, or none
  std::vector<Entries> lower_;             ///< by column: the rest of it, over its pivot
  std::vector<Entries> upper_;             ///< by column: the multiples of those before it
  std::vector<std::uint64_t> inverses_;    ///< of pivots
};

}  // namespace stickslip
