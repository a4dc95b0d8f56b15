// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Sums of square roots of rational numbers, compared exactly. Lengths of vectors in space are
/// such sums, and so are differences of lengths.
///
/// **Why signs are exact.** Square roots of positive rationals are linearly independent over
/// the rationals if no quotient of two of them is rational (Besicovitch 1940). Terms whose
/// roots have a rational quotient are added up. So a sum is 0 if and only if no term is left,
/// and the sign of a sum that is not 0 shows once it is enclosed narrowly enough.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/core/number.hpp"

namespace stickslip {

/// A sum c_1 sqrt(r_1) + ... + c_n sqrt(r_n).
class RootSum {
 public:
  /// A term factor * sqrt(radicand).
  struct Term {
    Rational factor;    ///< not 0
    Rational radicand;  ///< positive; 1 if the root is rational
  };

  RootSum() = default;             ///< 0
  RootSum(const Rational& value);  ///< a number, which is a sum
  /// Returns factor * sqrt(radicand). Requires radicand >= 0.
  static RootSum root(const Rational& factor, const Rational& radicand);

  /// Returns the terms, no two of which have roots with a rational quotient.
  const std::vector<Term>& terms() const { return terms_; }
  /// Returns the number if it is rational, else nothing.
  std::optional<Rational> rational() const;
  /// Returns the square of the sum if that is rational, else nothing. Requires at most three
  /// terms.
  std::optional<Rational> rational_square() const;
  /// Returns the sign: -1, 0 or 1. Exact.
  int sign() const;
  /// Returns two numbers between which the sum lies; both are the sum if it is rational. Each
  /// bit brings them closer by a factor of 2.
  std::pair<Rational, Rational> between(unsigned bits) const;

  /// \{ Adds, negates, subtracts and compares sums exactly.
  RootSum& operator+=(const RootSum& other);
  RootSum operator-() const;
  friend RootSum operator+(RootSum a, const RootSum& b) { return a += b; }
  friend RootSum operator-(RootSum a, const RootSum& b) { return a += -b; }
  friend bool operator<(const RootSum& a, const RootSum& b) { return (a - b).sign() < 0; }
  friend bool operator==(const RootSum& a, const RootSum& b) { return (a - b).terms_.empty(); }
  /// \}

 private:
  std::vector<Term> terms_;
};

/// Returns |value|.
RootSum magnitude(const RootSum& value);

/// Returns a closed decimal interval around the number, as enclose_sqrt() does for one root.
DecimalEnclosure enclose(const RootSum& value, int digits = 17);

/// Returns the number for people, as to_readable_string() does for a Rational.
std::string to_readable_string(const RootSum& value);

}  // namespace stickslip
