// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Sums of square roots of rational numbers, compared exactly: lengths of vectors in space, and
/// differences of such lengths.
///
/// **Why signs are exact.** Square roots of positive rationals, no quotient of two of which is
/// rational, are linearly independent over the rationals (Besicovitch 1940). Terms whose roots
/// have a rational quotient are added up, so a sum is 0 if and only if no term is left; and the
/// sign of one that is not 0 shows once it is enclosed narrowly enough.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/core/number.hpp"

namespace stickslip {

/// c_1 sqrt(r_1) + ... + c_n sqrt(r_n).
class RootSum {
 public:
  /// factor * sqrt(radicand).
  struct Term {
    Rational factor;    ///< not 0
    Rational radicand;  ///< positive; 1 if the root is rational
  };

  RootSum() = default;             ///< 0
  RootSum(const Rational& value);  ///< a number, which is a sum
  /// factor * sqrt(radicand). Requires radicand >= 0.
  static RootSum root(const Rational& factor, const Rational& radicand);

  /// No two have roots with a rational quotient.
  const std::vector<Term>& terms() const { return terms_; }
  /// The number, if it is rational.
  std::optional<Rational> rational() const;
  /// Its square, if that is rational. Requires at most three terms.
  std::optional<Rational> rational_square() const;
  /// -1, 0 or 1. Exact.
  int sign() const;
  /// Two numbers that it lies between, both times itself if it is rational: closer by a factor
  /// of 2 for each bit.
  std::pair<Rational, Rational> between(unsigned bits) const;

  /// \{ Exact.
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

/// |value|.
RootSum magnitude(const RootSum& value);

/// A closed decimal interval around the number, as of enclose_sqrt().
DecimalEnclosure enclose(const RootSum& value, int digits = 17);

/// For people, as of a Rational.
std::string to_readable_string(const RootSum& value);

}  // namespace stickslip
