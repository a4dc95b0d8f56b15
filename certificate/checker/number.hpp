// SPDX-License-Identifier: MIT
/// \file
/// Exact numbers: GMP's integers and rationals, and how the two files spell them.
///
/// gmpxx builds expression templates, so results are always given a type, never `auto`.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace stickslip_check {

using Integer = mpz_class;
using Rational = mpq_class;  ///< always in lowest terms, denominator > 0
using Vector2 = std::array<Rational, 2>;
using Vector3 = std::array<Rational, 3>;

/// A number of a grasp file: [+-] digits [. digits] [(e|E) [+-] digits], or
/// [+-] digits / digits. Nothing if `text` is not one, divides by zero, has more than 16384
/// characters or an exponent beyond 4096.
std::optional<Rational> parse_decimal(const std::string& text);

/// A NUMBER of a certificate (FORMAT.md §2): [-]digits or [-]digits/digits.
std::optional<Rational> parse_fraction(const std::string& text);

/// The square root of x >= 0, if it is rational.
std::optional<Rational> exact_sqrt(const Rational& x);

/// A decimal of three digits that is at least sqrt(x), x >= 0: "4.51e-10".
std::string decimal_above_sqrt(const Rational& x);

/// floor(2^shift x) and ceil(2^shift x).
Integer floor_shifted(const Rational& x, std::size_t shift);
Integer ceil_shifted(const Rational& x, std::size_t shift);
/// floor(2^shift x n)
Integer floor_shifted(const Rational& x, const Integer& n, std::size_t shift);

Rational dot(const Vector3& a, const Vector3& b);
Integer dot(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b);

/// a + s b
Vector3 sum(const Vector3& a, const Rational& s, const Vector3& b);

/// For messages: the number, or its beginning if it is very long.
std::string show(const Rational& x);
std::string show(const Vector3& v);

/// For messages: text from a file in quotation marks, without what a terminal would obey.
std::string quote(const std::string& text);

}  // namespace stickslip_check
