// SPDX-License-Identifier: MIT
/// \file
/// Exact numbers: GMP's integers and rationals, how the two files spell them, and how messages
/// show them.
///
/// gmpxx builds expression templates, so results are always given a type, never `auto`.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace stickslip_check {

using Integer = mpz_class;
using Rational = mpq_class;  ///< always in lowest terms, denominator > 0
using Vector = std::vector<Rational>;

/// The numbers from low to high, both included.
struct Bounds {
  Rational low;
  Rational high;

  Bounds() = default;
  /// One number.
  template <typename Number,
            typename = std::enable_if_t<std::is_convertible_v<Number, Rational>>>
  Bounds(const Number& value) : low(value), high(low) {}
  Bounds(Rational from, Rational to) : low(std::move(from)), high(std::move(to)) {}

  bool certain() const { return low == high; }
  friend bool operator==(const Bounds& a, const Bounds& b) {
    return a.low == b.low && a.high == b.high;
  }
};

/// A number of a grasp file (FORMAT.md §1): [+-] digits [. digits] [(e|E) [+-] digits], or
/// [+-] digits / digits. Nothing if `text` is not one, divides by zero, or exceeds a limit.
std::optional<Rational> parse_decimal(const std::string& text);

/// A NUMBER of a certificate (FORMAT.md §2): [-]digits or [-]digits/digits.
std::optional<Rational> parse_fraction(const std::string& text);

/// Integers without a common factor, or 0: a function of points up to a positive factor, or a
/// generator.
using Form = std::vector<Integer>;

/// Divides by the common factor and returns it, or 1 if all are 0.
Integer make_primitive(Form& x);
/// The positive multiple of `x` without denominators and common factors; x = *scale times it.
Form make_form(const Vector& x, Rational* scale = nullptr);
/// The forms of several vectors, all by one factor.
std::vector<Form> make_forms(const std::vector<Vector>& vectors, Rational* scale = nullptr);
Form negative(Form a);
Integer dot(const Form& a, const Form& b);
int sign_of_dot(const Form& a, const Form& b);

/// The square root of x >= 0, if it is rational.
std::optional<Rational> exact_sqrt(const Rational& x);
/// The same, or an enclosure with so many bits: FORMAT.md §6.
Bounds root_bounds(const Rational& x, unsigned bits);
/// "The bound" of the root of x, or of minus that of -x: the same, or what is a little larger
/// and short.
Rational root_above(const Rational& x);

/// The sum of products of as many coordinates as the shorter of the two has.
Rational dot(const Vector& a, const Vector& b);
/// sum += factor v.
void add(Vector& sum, const Rational& factor, const Vector& v);
/// Of three coordinates each.
Vector cross(const Vector& a, const Vector& b);

/// A sum of many vectors, added in pairs, then pairs of pairs and so on: denominators that have
/// nothing in common, as those of unit normals, then stay short for most of the additions.
class PairwiseSum {
 public:
  void add(Vector v);
  /// The sum, of which there must be one term.
  Vector total() const;

 private:
  std::vector<Vector> partial_;  ///< of 2^k terms each, for the bits k of count_, falling
  std::size_t count_ = 0;
};

/// For messages: the number, or its beginning if it is very long.
std::string show(const Rational& x);
std::string show(const Vector& v);
/// The number, or both ends: [1, 2].
std::string show(const Bounds& bounds);
std::string show(const std::vector<Bounds>& v);

/// For messages: the text with every byte that is not printable ASCII as \xNN.
std::string printable(const std::string& text);

/// For messages: the same in quotation marks, or its beginning if it is long.
std::string quote(const std::string& text);

}  // namespace stickslip_check
