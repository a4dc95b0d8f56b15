// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Vectors whose number of coordinates is known at run time, with the functions that
/// integer_vector.hpp has for those of fixed length.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip {

/// A vector of integers: a point, a plane, or a virtual twist.
using Row = std::vector<Integer>;
/// A vector of fractions.
using RationalRow = std::vector<Rational>;
/// A vector by its entries that are not 0, each with its index, in the order of these.
using SparseRow = std::vector<std::pair<std::size_t, Rational>>;

/// \{ Returns the sum of a_j b_j over the coordinates that both have. So a function of points
/// (d, h, l) may be given a motion d alone.
Integer dot(const Row& a, const Row& b);
Rational dot(const RationalRow& a, const RationalRow& b);
Rational dot(const Row& a, const RationalRow& b);
/// \}
/// Returns a vector by its entries that are not 0.
SparseRow sparse(const RationalRow& row);
/// Returns the product of a vector of few entries and one that has all of these.
Rational dot(const SparseRow& a, const RationalRow& b);
/// Adds `factor` times a vector of few entries.
void add_multiple(RationalRow& to, const Rational& factor, const SparseRow& row);

bool is_zero(const Row& a);  ///< whether every entry is 0
Row negated(Row a);          ///< -a
Row primitive(Row a);        ///< a divided by the greatest common divisor of its entries
Row primitive_multiple(const RationalRow& a);  ///< a positive multiple; 0 stays 0

/// \{ Returns the same numbers as a Row, or as a vector of fixed length. vector_of() requires
/// that there are n.
template <std::size_t n>
Row row_of(const IntegerVector<n>& a) {
  return {a.begin(), a.end()};
}
template <std::size_t n>
IntegerVector<n> vector_of(const Row& a) {
  require(a.size() == n, "a row of another length");
  IntegerVector<n> result;
  std::copy(a.begin(), a.end(), result.begin());
  return result;
}
/// \}

}  // namespace stickslip
