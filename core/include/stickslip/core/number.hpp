// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact numbers: arbitrary-precision integers and rationals (GMP), read exactly
/// as they are spelled and written so that reading gives the same number back.
///
/// Expression templates are off (et_off): `auto x = a + b` is a value and cannot
/// dangle. Division by zero throws std::overflow_error.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stickslip {

/// An integer of any length.
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int,
                                              boost::multiprecision::et_off>;
/// A fraction of two Integers, always in lowest terms with a positive denominator.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

/// A text that does not spell a number; what() says why, without the place.
class NumberError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// \{ \brief Largest |exponent| accepted in "1e-3", and largest length of a number's text:
/// enough for every double written out exactly, and small enough that no short
/// input costs more than a moment.
inline constexpr long kMaxExponent = 4096;
inline constexpr std::size_t kMaxNumberLength = 16384;
/// \}

/// The exact value of a decimal ("-0.25", "1e-3", "12") or a fraction of two
/// integers ("3/5"). Grammar: [+-] digits [. digits] [(e|E) [+-] digits], or
/// [+-] digits / digits. No blanks. Throws NumberError.
Rational parse_rational(std::string_view text);

/// "3/5", "-2": lowest terms, denominator omitted when 1. Inverse of parse_rational.
std::string to_string(const Rational& value);

/// The dyadic rational that a finite double is. Throws NumberError for NaN and infinities.
Rational rational_from_double(double value);

/// A number near `value` with a numerator of at most this many bits over or times a power of
/// two; 0 for NaN and infinities.
Rational rational_in_bits(double value, int bits);

/// The double nearest to `value`, ties to even; ±infinity or 0 beyond the range. For display
/// and for proposals that exact arithmetic then judges.
double to_double(const Rational& value);

/// sqrt(value) if it is rational, nothing otherwise. Requires value >= 0.
std::optional<Rational> exact_sqrt(const Rational& value);

/// A square root, or what it lies between.
struct ShortRoot {
  Rational lower;  ///< <= the root
  Rational upper;  ///< >= the root
};
/// sqrt(square), both times, if it is rational; else the greatest j / 2^s <= sqrt(square) with
/// integers s and 2^(bits - 1) <= j < 2^bits, and (j + 1) / 2^s. Requires square >= 0.
ShortRoot short_sqrt(const Rational& square, unsigned bits);

/// A closed decimal interval around an irrational number, both ends with as many significant
/// digits, rounded outward.
struct DecimalEnclosure {
  std::string lower;  ///< a decimal, <= the number
  std::string upper;  ///< a decimal, >= the number
};

/// Encloses factor * sqrt(radicand). Requires radicand >= 0.
DecimalEnclosure enclose_sqrt(const Rational& factor, const Rational& radicand,
                              int digits = 17);

/// What a number begins with that is rounded, not exact, in what is written for people.
inline constexpr char kRounded = '~';

/// For people. An integer of at most nine digits and a fraction of at most two digits over two
/// are written in full: "-2", "11/10". All else is a decimal of at most six significant digits,
/// with an exponent below 1e-4 and from 1e6 on: "21.534", "1e400". If that is not the exact
/// value but the nearest (ties away from 0), it begins with kRounded: "~0.142857".
std::string to_readable_string(const Rational& value);

/// The same of factor * sqrt(radicand). Requires radicand >= 0.
std::string to_readable_string(const Rational& factor, const Rational& radicand);

}  // namespace stickslip
