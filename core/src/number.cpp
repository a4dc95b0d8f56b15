// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/number.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "short_arithmetic.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using namespace core_detail;

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

[[noreturn]] void not_a_number(std::string_view text) {
  throw NumberError(quote(text) + " is not a number such as 2, -0.25, 1e-3 or 3/5");
}

/// Takes digits from the front of `rest`, appends them to `digits`, and returns how many there
/// were.
std::size_t take_digits(std::string_view& rest, std::string& digits) {
  std::size_t count = 0;
  while (count < rest.size() && is_digit(rest[count])) ++count;
  digits.append(rest.substr(0, count));
  rest.remove_prefix(count);
  return count;
}

/// Takes a sign from the front of `rest`. Returns true if it is '-'.
bool take_sign(std::string_view& rest) {
  if (rest.empty() || (rest.front() != '-' && rest.front() != '+')) return false;
  const bool negative = rest.front() == '-';
  rest.remove_prefix(1);
  return negative;
}

Integer integer_from_digits(const std::string& digits) {
  // GMP would read a leading zero as octal.
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos ? Integer(0) : Integer(digits.substr(first));
}

constexpr std::size_t kWordDigits = 18;  ///< a machine word holds every number of so many

std::uint64_t word_from_digits(const std::string& digits) {
  std::uint64_t value = 0;
  for (const char c : digits) value = 10 * value + static_cast<std::uint64_t>(c - '0');
  return value;
}

std::uint64_t word_power_of_ten(std::size_t exponent) {
  std::uint64_t value = 1;
  while (exponent-- > 0) value *= 10;
  return value;
}

Integer power_of_ten(long exponent) {
  return stickslip::pow(Integer(10), static_cast<unsigned>(exponent));
}

/// Returns value * 10^exponent.
Rational shifted(const Rational& value, long exponent) {
  const Integer power = power_of_ten(std::abs(exponent));
  return exponent < 0 ? value / power : value * power;
}

/// Spells digits * 10^unit >= 0, with an exponent if it is below 1e-4 or from 1e6 on.
std::string spell_decimal(Integer digits, long unit) {
  if (digits.is_zero()) return "0";
  while (digits % 10 == 0) {
    digits /= 10;
    ++unit;
  }
  std::string text = digits.str();
  const long exponent = static_cast<long>(text.size()) - 1 + unit;  // the first digit
  if (exponent < -4 || exponent >= 6) {
    if (text.size() > 1) text.insert(1, ".");
    return text + "e" + std::to_string(exponent);
  }
  if (unit >= 0) return text + std::string(static_cast<std::size_t>(unit), '0');
  if (exponent < 0) text.insert(0, static_cast<std::size_t>(-exponent), '0');
  text.insert(text.size() - static_cast<std::size_t>(-unit), ".");
  return text;
}

/// Returns floor(sqrt(square) / 10^unit).
Integer units_below(const Rational& square, long unit) {
  const Rational scaled = shifted(square, -2 * unit);
  return sqrt(Integer(numerator(scaled) / denominator(scaled)));
}

/// Returns the least u for which floor(sqrt(square) / 10^u) has at most `digits` digits; it
/// then has just as many. Requires square > 0.
long unit_for(const Rational& square, long digits) {
  const auto length = [](const Integer& n) {  // the number of decimal digits, or one more
    return static_cast<long>(mpz_sizeinbase(n.gmp(), 10));
  };
  // The search starts from a unit that is too small by a few powers of ten.
  long unit = (length(numerator(square)) - length(denominator(square))) / 2 - digits - 1;
  while (units_below(square, unit) >= power_of_ten(digits)) ++unit;
  return unit;
}

bool is_root(const Integer& units, long unit, const Rational& square) {
  return shifted(units * units, 2 * unit) == square;
}

/// Returns the decimal of to_readable_string. `square` is the square of the number, and not 0.
std::string readable_decimal(bool negative, const Rational& square) {
  const long unit = unit_for(square, 6);
  const Integer units = (units_below(4 * square, unit) + 1) / 2;  // rounded
  return (is_root(units, unit, square) ? "" : std::string(1, kRounded)) +
         (negative ? "-" : "") + spell_decimal(units, unit);
}

}  // namespace

Rational parse_rational(std::string_view text) {
  if (text.size() > kMaxNumberLength) {
    throw NumberError("a number of " + std::to_string(text.size()) + " characters; at most " +
                      std::to_string(kMaxNumberLength) + " are read");
  }
  std::string_view rest = text;
  const bool negative = take_sign(rest);
  std::string digits;
  if (take_digits(rest, digits) == 0) not_a_number(text);
  Rational value;
  if (!rest.empty() && rest.front() == '/') {
    rest.remove_prefix(1);
    std::string denominator_digits;
    if (take_digits(rest, denominator_digits) == 0 || !rest.empty()) not_a_number(text);
    if (denominator_digits.find_first_not_of('0') == std::string::npos) {
      throw NumberError(quote(text) + " divides by zero");
    }
    value =
        std::max(digits.size(), denominator_digits.size()) <= kWordDigits
            ? short_fraction(word_from_digits(digits), word_from_digits(denominator_digits))
            : Rational(integer_from_digits(digits), integer_from_digits(denominator_digits));
  } else {
    long exponent = 0;
    if (!rest.empty() && rest.front() == '.') {
      rest.remove_prefix(1);
      const std::size_t decimals = take_digits(rest, digits);
      if (decimals == 0) not_a_number(text);
      exponent -= static_cast<long>(decimals);
    }
    if (!rest.empty() && (rest.front() == 'e' || rest.front() == 'E')) {
      rest.remove_prefix(1);
      const bool negative_exponent = take_sign(rest);
      std::string exponent_digits;
      if (take_digits(rest, exponent_digits) == 0 || !rest.empty()) not_a_number(text);
      const Integer magnitude = integer_from_digits(exponent_digits);
      if (magnitude > kMaxExponent) {
        throw NumberError("the exponent of " + quote(text) + " exceeds " +
                          std::to_string(kMaxExponent));
      }
      const long spelled = magnitude.convert_to<long>();
      exponent += negative_exponent ? -spelled : spelled;
    }
    if (!rest.empty()) not_a_number(text);
    const auto shift = static_cast<std::size_t>(std::abs(exponent));
    if (exponent <= 0 && std::max(digits.size(), shift) <= kWordDigits) {
      value = short_fraction(word_from_digits(digits), word_power_of_ten(shift));
    } else {
      const Integer mantissa = integer_from_digits(digits);
      value = exponent >= 0 ? Rational(mantissa * power_of_ten(exponent))
                            : Rational(mantissa, power_of_ten(-exponent));
    }
  }
  if (negative) value.negate();
  return value;
}

std::string to_string(const Rational& value) {
  return value.str();
}

Rational rational_from_double(double value) {
  if (!std::isfinite(value)) throw NumberError("not a finite number");
  Rational result;
  mpq_set_d(result.mutable_gmp(), value);
  return result;
}

Rational rational_in_bits(double value, int bits) {
  if (value == 0 || !std::isfinite(value)) return 0;
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  return rational_from_double(
      std::ldexp(std::round(std::ldexp(mantissa, bits)), exponent - bits));
}

double to_double(const Rational& value) {
  using Double = std::numeric_limits<double>;
  mpz_srcptr num = mpq_numref(value.gmp());
  mpz_srcptr den = mpq_denref(value.gmp());
  // The machine rounds the quotient of two doubles once, and to nearest unless it is told
  // otherwise.
  if (FLT_EVAL_METHOD == 0 && mpz_sizeinbase(num, 2) <= Double::digits &&
      mpz_sizeinbase(den, 2) <= Double::digits) {
    return mpz_get_d(num) / mpz_get_d(den);
  }
  mpfr_t rounded;
  mpfr_init2(rounded, Double::digits);
  // The exponents are limited to those of doubles, so that a subnormal is rounded once, to the
  // digits it has.
  const mpfr_exp_t before = mpfr_get_emin();
  mpfr_set_emin(Double::min_exponent - Double::digits + 1);
  const int direction = mpfr_set_q(rounded, value.gmp(), MPFR_RNDN);
  mpfr_subnormalize(rounded, direction, MPFR_RNDN);
  mpfr_set_emin(before);
  const double nearest = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  return nearest;
}

std::optional<Rational> exact_sqrt(const Rational& value) {
  require(value.sign() >= 0, "exact_sqrt of a negative number");
  mpq_srcptr square = value.gmp();
  // The fraction is in lowest terms: its root is rational iff both parts are squares, and is
  // then in lowest terms as well.
  if (mpz_perfect_square_p(mpq_numref(square)) == 0 ||
      mpz_perfect_square_p(mpq_denref(square)) == 0) {
    return std::nullopt;
  }
  Rational root;
  mpz_sqrt(mpq_numref(root.mutable_gmp()), mpq_numref(square));
  mpz_sqrt(mpq_denref(root.mutable_gmp()), mpq_denref(square));
  return root;
}

ShortRoot short_sqrt(const Rational& square, unsigned bits) {
  if (const auto root = exact_sqrt(square)) return {*root, *root};
  const Integer& num = numerator(square);
  const Integer& den = denominator(square);
  // 2^s sqrt(square) has j as its whole part: s such that j has the right number of bits is at
  // most one off the difference of the lengths.
  long s = static_cast<long>(bits) -
           (static_cast<long>(msb(num)) - static_cast<long>(msb(den))) / 2 - 1;
  const auto whole = [&](long shift) -> Integer {
    const auto by = static_cast<unsigned long>(std::labs(2 * shift));
    return sqrt(Integer(shift >= 0 ? Integer(num << by) / den : num / Integer(den << by)));
  };
  Integer j = whole(s);
  while (msb(j) + 1 < bits) j = whole(++s);
  while (msb(j) + 1 > bits) j = whole(--s);
  const Integer unit = Integer(1) << static_cast<unsigned long>(std::labs(s));
  const auto scaled = [&](const Integer& n) {
    return s >= 0 ? Rational(n, unit) : Rational(n * unit);
  };
  return {scaled(j), scaled(j + 1)};
}

DecimalEnclosure enclose_sqrt(const Rational& factor, const Rational& radicand, int digits) {
  require(radicand.sign() >= 0, "enclose_sqrt of a negative number");
  const Rational square = factor * factor * radicand;
  if (square.is_zero()) return {"0", "0"};
  const long unit = unit_for(square, digits);
  const Integer units = units_below(square, unit);
  const std::string below = spell_decimal(units, unit);
  const std::string above =
      is_root(units, unit, square) ? below : spell_decimal(units + 1, unit);
  if (factor.sign() < 0) return {"-" + above, "-" + below};
  return {below, above};
}

DecimalEnclosure enclose(const Rational& low, const Rational& high) {
  require(low.sign() >= 0 && low < high, "an interval of numbers that are not below 0");
  int places = 0;
  while (Rational(1, power_of_ten(places)) > high - low) ++places;
  const Integer scale = power_of_ten(places);
  const auto below = [&](const Rational& value) {
    return Integer(numerator(value) / denominator(value));
  };
  const Integer above = below(high * scale);
  const Integer upper = above == high * scale ? above : Integer(above + 1);
  return {spell_decimal(below(low * scale), -places), spell_decimal(upper, -places)};
}

std::string to_readable_string(const Rational& value) {
  const Integer bound = power_of_ten(denominator(value) == 1 ? 9 : 2);
  if (abs(numerator(value)) < bound && denominator(value) < bound) return to_string(value);
  return readable_decimal(value.sign() < 0, value * value);
}

std::string to_percent_string(const Rational& share) {
  const Rational value = 100 * share;
  return (value.is_zero() ? "0" : readable_decimal(value.sign() < 0, value * value)) + " %";
}

std::string to_readable_string(const Rational& factor, const Rational& radicand) {
  require(radicand.sign() >= 0, "to_readable_string of the root of a negative number");
  if (const auto root = exact_sqrt(radicand)) return to_readable_string(factor * *root);
  if (factor.is_zero()) return "0";
  return readable_decimal(factor.sign() < 0, factor * factor * radicand);
}

}  // namespace stickslip
