// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact numbers: arbitrary-precision integers and rationals (GMP), read exactly
/// as they are spelled and written so that reading gives the same number back.
///
/// Every operator returns a value: `auto x = a + b` cannot dangle. Division by zero throws
/// std::overflow_error. Arithmetic is compiled once, in integer.cpp and rational.cpp: a file
/// that includes this one compiles only what signs, comparisons with words and moves take.
#pragma once

#include <gmp.h>

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace stickslip {

class Integer;
class Rational;

namespace core_detail {

// Since 6.2, GMP takes memory for a number when it is first written to, not before.
static_assert(__GNU_MP_RELEASE >= 60200, "stickslip needs GMP 6.2");

/// \{ The integer types of the machine, of at most 64 bits.
template <class T>
inline constexpr bool kIsWord =
    std::is_integral_v<T> && !std::is_same_v<T, bool> && sizeof(T) <= sizeof(long);
template <class T>
using IfWord = std::enable_if_t<kIsWord<T>, int>;
/// \}

/// An integer of the machine, signed or not, by its sign and its size.
struct Word {
  /// Takes the sign and the size of `value`.
  template <class T>
  constexpr explicit Word(T value) : size(static_cast<unsigned long>(value)) {
    if constexpr (std::is_signed_v<T>) {
      negative = value < 0;
      if (negative) size = -size;
    }
  }
  unsigned long size;     ///< the absolute value
  bool negative = false;  ///< whether the integer is below 0
};

/// \{ The limbs of a 0 and of a 1 that own no memory (`_mp_alloc` is 0). GMP reads them as it
/// reads all others.
inline constexpr mp_limb_t kLimbOfZero = 0;
inline constexpr mp_limb_t kLimbOfOne = 1;
inline __mpz_struct zero_without_memory() noexcept {
  return {0, 0, const_cast<mp_limb_t*>(&kLimbOfZero)};
}
inline __mpz_struct one_without_memory() noexcept {
  return {0, 1, const_cast<mp_limb_t*>(&kLimbOfOne)};
}
/// \}

/// Allows a Number to be compared, added, ... with a T as it is: with words, and a Rational
/// with an Integer too.
template <class Number, class T>
using IfBeside = std::enable_if_t<
    kIsWord<T> || (std::is_same_v<Number, Rational> && std::is_same_v<T, Integer>), int>;

/// The operators that both kinds of number have. They follow from a few functions of each.
template <class Number>
class Operators {
  // Comparisons.
  friend bool operator==(const Number& a, const Number& b) { return a.equals(b); }
  friend bool operator!=(const Number& a, const Number& b) { return !a.equals(b); }
  friend bool operator<(const Number& a, const Number& b) { return a.compare(b) < 0; }
  friend bool operator>(const Number& a, const Number& b) { return a.compare(b) > 0; }
  friend bool operator<=(const Number& a, const Number& b) { return a.compare(b) <= 0; }
  friend bool operator>=(const Number& a, const Number& b) { return a.compare(b) >= 0; }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator==(const Number& a, const T& b) {
    return a.compare(b) == 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator!=(const Number& a, const T& b) {
    return a.compare(b) != 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator<(const Number& a, const T& b) {
    return a.compare(b) < 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator>(const Number& a, const T& b) {
    return a.compare(b) > 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator<=(const Number& a, const T& b) {
    return a.compare(b) <= 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator>=(const Number& a, const T& b) {
    return a.compare(b) >= 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator==(const T& a, const Number& b) {
    return b.compare(a) == 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator!=(const T& a, const Number& b) {
    return b.compare(a) != 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator<(const T& a, const Number& b) {
    return b.compare(a) > 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator>(const T& a, const Number& b) {
    return b.compare(a) < 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator<=(const T& a, const Number& b) {
    return b.compare(a) >= 0;
  }
  template <class T, IfBeside<Number, T> = 0>
  friend bool operator>=(const T& a, const Number& b) {
    return b.compare(a) <= 0;
  }

  // A temporary lends its memory to the result.
  friend Number operator+(Number&& a, const Number& b) { return std::move(a += b); }
  friend Number operator+(const Number& a, Number&& b) { return std::move(b += a); }
  friend Number operator+(Number&& a, Number&& b) { return std::move(a += b); }
  friend Number operator-(Number&& a, const Number& b) { return std::move(a -= b); }
  friend Number operator-(const Number& a, Number&& b) {
    b -= a;
    b.negate();
    return std::move(b);
  }
  friend Number operator-(Number&& a, Number&& b) { return std::move(a -= b); }
  friend Number operator*(Number&& a, const Number& b) { return std::move(a *= b); }
  friend Number operator*(const Number& a, Number&& b) { return std::move(b *= a); }
  friend Number operator*(Number&& a, Number&& b) { return std::move(a *= b); }

  friend Number operator-(Number a) {
    a.negate();
    return a;
  }
  friend const Number& operator+(const Number& a) { return a; }
  friend void swap(Number& a, Number& b) noexcept { a.swap(b); }
};

}  // namespace core_detail

/// An integer of any length. A moved-from Integer is 0.
class Integer : public core_detail::Operators<Integer> {
 public:
  /// \{ Makes 0, a copy, or an integer of the machine.
  Integer() noexcept : z_(core_detail::zero_without_memory()) {}
  Integer(const Integer& other) noexcept : Integer() {
    if (other.z_._mp_size != 0) set(other);
  }
  Integer(Integer&& other) noexcept : z_(other.z_) {
    other.z_ = core_detail::zero_without_memory();
  }
  template <class T, core_detail::IfWord<T> = 0>
  Integer(T value) noexcept : Integer() {
    if (value != 0) set(core_detail::Word(value));
  }
  /// \}
  /// Rounds towards 0. Throws std::overflow_error for NaN and infinities.
  explicit Integer(double value);
  /// Rounds towards 0.
  explicit Integer(const Rational& value);
  /// Reads decimal digits, with a '-' before them or not. Throws std::invalid_argument for any
  /// other text.
  explicit Integer(const std::string& digits);
  ~Integer() {
    if (z_._mp_alloc != 0) mpz_clear(&z_);
  }
  /// \{ *this becomes the other number.
  Integer& operator=(const Integer& other) noexcept {
    set(other);
    return *this;
  }
  Integer& operator=(Integer&& other) noexcept {
    swap(other);
    return *this;
  }
  template <class T, core_detail::IfWord<T> = 0>
  Integer& operator=(T value) noexcept {
    set(core_detail::Word(value));
    return *this;
  }
  /// \}

  /// \{ Returns the number in the form that functions of GMP take, to read, or to read and
  /// write.
  mpz_srcptr gmp() const { return &z_; }
  mpz_ptr mutable_gmp() { return &z_; }
  /// \}

  /// Returns whether it is 0.
  bool is_zero() const { return z_._mp_size == 0; }
  /// Returns the sign: -1, 0 or 1.
  int sign() const { return z_._mp_size < 0 ? -1 : z_._mp_size > 0 ? 1 : 0; }
  /// \{ Returns a number below, at or above 0, if *this is below, at or above `other`.
  int compare(const Integer& other) const { return mpz_cmp(&z_, &other.z_); }
  template <class T, core_detail::IfWord<T> = 0>
  int compare(T other) const {
    return other == 0 ? z_._mp_size : compare_word(core_detail::Word(other));
  }
  /// \}
  /// Returns whether the two are one number.
  bool equals(const Integer& other) const {
    return z_._mp_size == other.z_._mp_size && mpz_cmp(&z_, &other.z_) == 0;
  }
  /// Changes the sign.
  void negate() noexcept { z_._mp_size = -z_._mp_size; }
  /// Exchanges the two numbers. O(1).
  void swap(Integer& other) noexcept { std::swap(z_, other.z_); }
  /// Returns decimal digits, with a '-' before those of a negative number.
  std::string str() const;
  /// Returns the same number as a `T` (`long`, `std::size_t`, ...). Throws std::overflow_error
  /// if it does not fit.
  template <class T, core_detail::IfWord<T> = 0>
  T convert_to() const {
    if constexpr (std::is_signed_v<T>) {
      const long word = to_long();
      const auto result = static_cast<T>(word);
      if (result != word) too_long();
      return result;
    } else {
      const unsigned long word = to_unsigned_long();
      const auto result = static_cast<T>(word);
      if (result != word) too_long();
      return result;
    }
  }

  /// \{ *this becomes the sum, the difference or the product.
  Integer& operator+=(const Integer& b) noexcept;
  Integer& operator-=(const Integer& b) noexcept;
  Integer& operator*=(const Integer& b) noexcept;
  /// \}
  /// \{ Division rounds towards 0, and throws std::overflow_error if b is 0.
  Integer& operator/=(const Integer& b);
  Integer& operator%=(const Integer& b);
  /// \}
  /// \{ *this becomes the result with an integer of the machine.
  template <class T, core_detail::IfWord<T> = 0>
  Integer& operator+=(T b) noexcept {
    add(*this, core_detail::Word(b));
    return *this;
  }
  template <class T, core_detail::IfWord<T> = 0>
  Integer& operator-=(T b) noexcept {
    subtract(*this, core_detail::Word(b));
    return *this;
  }
  template <class T, core_detail::IfWord<T> = 0>
  Integer& operator*=(T b) noexcept {
    multiply(*this, core_detail::Word(b));
    return *this;
  }
  /// \}
  /// \{ Multiply and divide by 2^bits. A quotient is rounded down.
  Integer& operator<<=(unsigned long bits) noexcept;
  Integer& operator>>=(unsigned long bits) noexcept;
  /// \}
  /// \{ *this becomes the next integer, or the one before.
  Integer& operator++() noexcept { return *this += 1; }
  Integer& operator--() noexcept { return *this -= 1; }
  /// \}

  /// \{ Return the results of the operators above, as values.
  friend Integer operator+(const Integer& a, const Integer& b) noexcept;
  friend Integer operator-(const Integer& a, const Integer& b) noexcept;
  friend Integer operator*(const Integer& a, const Integer& b) noexcept;
  friend Integer operator/(const Integer& a, const Integer& b);
  friend Integer operator%(const Integer& a, const Integer& b);
  friend Integer operator<<(const Integer& a, unsigned long bits) noexcept;
  friend Integer operator>>(const Integer& a, unsigned long bits) noexcept;
  /// \}
  /// Returns the bits that both have, as numbers in two's complement.
  friend Integer operator&(const Integer& a, const Integer& b) noexcept;

 private:
  friend class Rational;

  void set(const Integer& value) noexcept;
  void set(core_detail::Word value) noexcept;
  void add(const Integer& a, core_detail::Word b) noexcept;
  void subtract(const Integer& a, core_detail::Word b) noexcept;
  void multiply(const Integer& a, core_detail::Word b) noexcept;
  int compare_word(core_detail::Word other) const noexcept;
  long to_long() const;
  unsigned long to_unsigned_long() const;
  [[noreturn]] static void too_long();

  __mpz_struct z_;
};

/// A fraction of two Integers, always in lowest terms with a positive denominator. A moved-from
/// Rational is 0. A denominator of 1 mostly owns no memory.
class Rational : public core_detail::Operators<Rational> {
 public:
  /// \{ Makes 0, a copy, or an integer.
  Rational() noexcept : q_(zero()) {}
  Rational(const Rational& other) noexcept;
  Rational(Rational&& other) noexcept : q_(other.q_) { other.q_ = zero(); }
  Rational(const Integer& value) noexcept;
  Rational(Integer&& value) noexcept : q_{value.z_, core_detail::one_without_memory()} {
    value.z_ = core_detail::zero_without_memory();
  }
  template <class T, core_detail::IfWord<T> = 0>
  Rational(T value) noexcept : Rational() {
    if (value != 0) set_numerator(core_detail::Word(value));
  }
  /// \}
  /// Doubles do not convert by themselves: rational_from_double() reads them.
  template <class T, std::enable_if_t<std::is_floating_point_v<T>, int> = 0>
  Rational(T value) = delete;
  /// \{ Makes a quotient. Throws std::overflow_error if the denominator is 0.
  Rational(Integer numerator, Integer denominator);
  template <class A, class B, core_detail::IfWord<A> = 0, core_detail::IfWord<B> = 0>
  Rational(A numerator, B denominator)
      : Rational(core_detail::Word(numerator), core_detail::Word(denominator)) {}
  /// \}
  /// Reads decimal digits, with a '-' before them or not, and with a '/' and digits behind them
  /// or not. Throws std::invalid_argument for any other text.
  explicit Rational(const std::string& text);
  ~Rational() {
    if (q_._mp_num._mp_alloc != 0) mpz_clear(&q_._mp_num);
    if (q_._mp_den._mp_alloc != 0) mpz_clear(&q_._mp_den);
  }
  /// \{ *this becomes the other number.
  Rational& operator=(const Rational& other) noexcept;
  Rational& operator=(Rational&& other) noexcept {
    swap(other);
    return *this;
  }
  /// \}

  /// \{ Returns the number in the form that functions of GMP take, to read, or to read and
  /// write. A fraction that is written has to be in lowest terms.
  mpq_srcptr gmp() const { return &q_; }
  mpq_ptr mutable_gmp() {
    own();
    return &q_;
  }
  /// \}

  /// Returns whether it is 0.
  bool is_zero() const { return q_._mp_num._mp_size == 0; }
  /// Returns the sign: -1, 0 or 1.
  int sign() const {
    const int size = q_._mp_num._mp_size;
    return size < 0 ? -1 : size > 0 ? 1 : 0;
  }
  /// Returns whether the denominator is 1.
  bool is_integer() const { return q_._mp_den._mp_size == 1 && q_._mp_den._mp_d[0] == 1; }
  /// \{ Returns a number below, at or above 0, if *this is below, at or above `other`.
  int compare(const Rational& other) const noexcept;
  int compare(const Integer& other) const noexcept;
  template <class T, core_detail::IfWord<T> = 0>
  int compare(T other) const noexcept {
    return other == 0 ? q_._mp_num._mp_size : compare_word(core_detail::Word(other));
  }
  /// \}
  /// Returns whether the two are one number.
  bool equals(const Rational& other) const noexcept;
  /// Changes the sign.
  void negate() noexcept { q_._mp_num._mp_size = -q_._mp_num._mp_size; }
  /// Exchanges the two numbers. O(1).
  void swap(Rational& other) noexcept { std::swap(q_, other.q_); }
  /// Returns "3/5", "-2" or the like, without a denominator of 1.
  std::string str() const;

  /// \{ *this becomes the sum, the difference or the product.
  Rational& operator+=(const Rational& b) noexcept;
  Rational& operator-=(const Rational& b) noexcept;
  Rational& operator*=(const Rational& b) noexcept;
  /// \}
  /// *this becomes the quotient. Throws std::overflow_error if b is 0.
  Rational& operator/=(const Rational& b);

  /// \{ Return the results of the operators above, as values.
  friend Rational operator+(const Rational& a, const Rational& b) noexcept;
  friend Rational operator-(const Rational& a, const Rational& b) noexcept;
  friend Rational operator*(const Rational& a, const Rational& b) noexcept;
  friend Rational operator/(const Rational& a, const Rational& b);
  friend Rational operator/(Rational&& a, const Rational& b) { return std::move(a /= b); }
  /// \}

  /// \{ Returns the numerator, or the denominator, of the fraction in lowest terms.
  friend Integer numerator(const Rational& value) noexcept;
  friend Integer denominator(const Rational& value) noexcept;
  /// \}
  /// Returns |value|.
  friend Rational abs(Rational value) noexcept {
    if (value.sign() < 0) value.negate();
    return value;
  }

 private:
  Rational(core_detail::Word numerator, core_detail::Word denominator);
  static __mpq_struct zero() noexcept {
    return {core_detail::zero_without_memory(), core_detail::one_without_memory()};
  }
  /// Gives the denominator memory of its own.
  void own() noexcept {
    if (q_._mp_den._mp_alloc == 0) mpz_init_set_ui(&q_._mp_den, 1);
  }
  void set_numerator(core_detail::Word value) noexcept;
  void set_denominator_to_one() noexcept;
  int compare_word(core_detail::Word other) const noexcept;
  /// \{ *this becomes a + b, a - b, a * b or a / b. One of a and b may be *this.
  void add(const Rational& a, const Rational& b, bool negative) noexcept;
  void multiply(const Rational& a, const Rational& b) noexcept;
  void divide(const Rational& a, const Rational& b);
  /// \}

  __mpq_struct q_;
};

/// \{ Returns the numerator, or the denominator, of the fraction in lowest terms.
Integer numerator(const Rational& value) noexcept;
Integer denominator(const Rational& value) noexcept;
/// \}
/// |value|.
inline Integer abs(Integer value) noexcept {
  if (value.sign() < 0) value.negate();
  return value;
}
/// \{ Return the greatest common divisor and the least common multiple, which are not negative;
/// gcd(0, a) is |a|, and lcm(0, a) is 0.
Integer gcd(const Integer& a, const Integer& b) noexcept;
Integer lcm(const Integer& a, const Integer& b) noexcept;
/// \}
/// Returns `base` to the power `exponent`, which is 1 for the exponent 0.
Integer pow(const Integer& base, unsigned exponent) noexcept;
/// Returns the square root, rounded down. Requires value >= 0.
Integer sqrt(const Integer& value);
/// Returns the place of the highest bit, 0 for 1. Requires value > 0.
std::size_t msb(const Integer& value);
/// \{ Write what str() returns.
std::ostream& operator<<(std::ostream& out, const Integer& value);
std::ostream& operator<<(std::ostream& out, const Rational& value);
/// \}

/// An error about a text that does not spell a number; what() says why, without the place.
class NumberError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// \{ \brief The largest |exponent| accepted in "1e-3", and the greatest length of a number's
/// text: enough for every double written out exactly, and small enough that no short input
/// costs more than a moment.
inline constexpr long kMaxExponent = 4096;
inline constexpr std::size_t kMaxNumberLength = 16384;
/// \}

/// Returns the exact value of a decimal ("-0.25", "1e-3", "12") or of a fraction of two
/// integers ("3/5"). The grammar is [+-] digits [. digits] [(e|E) [+-] digits], or [+-] digits
/// / digits, without blanks. Throws NumberError.
Rational parse_rational(std::string_view text);

/// Returns "3/5", "-2" or the like: lowest terms, without a denominator of 1. It is the inverse
/// of parse_rational.
std::string to_string(const Rational& value);

/// Returns the dyadic rational that a finite double is. Throws NumberError for NaN and
/// infinities.
Rational rational_from_double(double value);

/// Returns a number near `value` that is a power of two times an integer of at most this many
/// bits; 0 for NaN and infinities.
Rational rational_in_bits(double value, int bits);

/// Returns the double nearest to `value`, ties to even; ±infinity or 0 beyond the range. It
/// serves display, and proposals that exact arithmetic then judges.
double to_double(const Rational& value);

/// Returns sqrt(value) if it is rational, nothing otherwise. Requires value >= 0.
std::optional<Rational> exact_sqrt(const Rational& value);

/// Two numbers between which a square root lies; both are the root if it is rational.
struct ShortRoot {
  Rational lower;  ///< <= the root
  Rational upper;  ///< >= the root
};
/// Returns sqrt(square) twice if it is rational. Else returns the greatest j / 2^s <=
/// sqrt(square) with integers s and 2^(bits - 1) <= j < 2^bits, and (j + 1) / 2^s. Requires
/// square >= 0.
ShortRoot short_sqrt(const Rational& square, unsigned bits);

/// A closed decimal interval around an irrational number. Both ends have as many significant
/// digits and are rounded outward.
struct DecimalEnclosure {
  std::string lower;  ///< a decimal, <= the number
  std::string upper;  ///< a decimal, >= the number
};

/// Returns an interval around factor * sqrt(radicand). Requires radicand >= 0.
DecimalEnclosure enclose_sqrt(const Rational& factor, const Rational& radicand,
                              int digits = 17);

/// Returns decimals around the numbers from low to high, rounded outward: each is less than
/// high - low from its end. Requires 0 <= low < high.
DecimalEnclosure enclose(const Rational& low, const Rational& high);

/// The mark before a number that is rounded, not exact, in text for people.
inline constexpr char kRounded = '~';

/// Returns the number for people. An integer of at most nine digits and a fraction of at most
/// two digits over two are written in full: "-2", "11/10". All else is a decimal of at most six
/// significant digits, with an exponent below 1e-4 and from 1e6 on: "21.534", "1e400". If that
/// is not the exact value but the nearest (ties away from 0), it begins with kRounded:
/// "~0.142857".
std::string to_readable_string(const Rational& value);

/// Returns a share for people, as "37.5 %": always a decimal, rounded and marked in the same way.
std::string to_percent_string(const Rational& share);

/// Returns factor * sqrt(radicand) for people, in the same form. Requires radicand >= 0.
std::string to_readable_string(const Rational& factor, const Rational& radicand);

}  // namespace stickslip
