// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <numeric>
#include <ostream>

#include "divide_by_zero.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/number.hpp"

namespace stickslip {

using core_detail::Word;

namespace {

__extension__ typedef unsigned __int128 DoubleWord;

bool is_one(mpz_srcptr value) {
  return value->_mp_size == 1 && value->_mp_d[0] == 1;
}

/// A fraction whose parts are below 2^63.
struct ShortFraction {
  std::uint64_t size;  ///< the absolute value of the numerator
  std::uint64_t denominator;
  bool negative;
};

/// Reads a fraction; returns false, and leaves `to` unchanged, if a part is longer.
bool read_short(mpq_srcptr value, ShortFraction& to) {
  mpz_srcptr num = mpq_numref(value);
  mpz_srcptr den = mpq_denref(value);
  constexpr std::uint64_t kBelow = std::uint64_t{1} << 63;
  if (num->_mp_size < -1 || num->_mp_size > 1 || den->_mp_size > 1) return false;
  const std::uint64_t size = num->_mp_size == 0 ? 0 : num->_mp_d[0];
  const std::uint64_t denominator = den->_mp_d[0];
  if (((size | denominator) & kBelow) != 0) return false;
  to = {size, denominator, num->_mp_size < 0};
  return true;
}

void write(mpz_ptr to, DoubleWord size, bool negative) {
  const auto low = static_cast<mp_limb_t>(size);
  const auto high = static_cast<mp_limb_t>(size >> 64);
  const int limbs = high != 0 ? 2 : low != 0 ? 1 : 0;
  mp_limb_t* const limb = to->_mp_alloc >= limbs ? to->_mp_d : mpz_limbs_write(to, limbs);
  if (limbs > 0) limb[0] = low;
  if (limbs > 1) limb[1] = high;
  to->_mp_size = negative ? -limbs : limbs;
}

/// Writes a denominator. A 1 that owns no memory stays so.
void write_denominator(mpz_ptr to, DoubleWord value) {
  if (value != 1 || !is_one(to)) write(to, value, false);
}

/// `to` becomes the product of the two.
void write_product(mpq_ptr to, const ShortFraction& p, const ShortFraction& q) {
  const std::uint64_t g = std::gcd(p.size, q.denominator);
  const std::uint64_t h = std::gcd(q.size, p.denominator);
  write(mpq_numref(to), DoubleWord{p.size / g} * (q.size / h), p.negative != q.negative);
  write_denominator(mpq_denref(to), DoubleWord{p.denominator / h} * (q.denominator / g));
}

}  // namespace

Rational::Rational(const Rational& other) noexcept : q_(zero()) {
  mpz_set(&q_._mp_num, &other.q_._mp_num);
  if (!other.is_integer()) mpz_init_set(&q_._mp_den, &other.q_._mp_den);
}

Rational::Rational(const Integer& value) noexcept : q_(zero()) {
  mpz_set(&q_._mp_num, &value.z_);
}

Rational::Rational(Integer numerator, Integer denominator) : q_(zero()) {
  if (denominator.is_zero()) core_detail::divide_by_zero();
  std::swap(q_._mp_num, numerator.z_);
  if (is_one(&denominator.z_)) return;
  q_._mp_den = denominator.z_;
  denominator.z_ = core_detail::zero_without_memory();
  mpq_canonicalize(&q_);
}

Rational::Rational(Word numerator, Word denominator) : q_(zero()) {
  if (denominator.size == 0) core_detail::divide_by_zero();
  const unsigned long divisor = std::gcd(numerator.size, denominator.size);
  set_numerator(numerator);
  if (divisor != 1) mpz_divexact_ui(&q_._mp_num, &q_._mp_num, divisor);
  if (denominator.negative) negate();
  if (denominator.size != divisor) mpz_init_set_ui(&q_._mp_den, denominator.size / divisor);
}

Rational::Rational(const std::string& text) : q_(zero()) {
  const std::size_t bar = text.find('/');
  if (bar == std::string::npos) {
    *this = Integer(text);
  } else {
    *this = Rational(Integer(text.substr(0, bar)), Integer(text.substr(bar + 1)));
  }
}

Rational& Rational::operator=(const Rational& other) noexcept {
  mpz_set(&q_._mp_num, &other.q_._mp_num);
  if (other.is_integer()) {
    set_denominator_to_one();
  } else {
    mpz_set(&q_._mp_den, &other.q_._mp_den);
  }
  return *this;
}

void Rational::set_numerator(Word value) noexcept {
  mpz_set_ui(&q_._mp_num, value.size);
  if (value.negative) negate();
}

void Rational::set_denominator_to_one() noexcept {
  if (!is_integer()) mpz_set_ui(&q_._mp_den, 1);
}

int Rational::compare(const Rational& other) const noexcept {
  if (q_._mp_den._mp_size == 1 && other.q_._mp_den._mp_size == 1 &&
      q_._mp_den._mp_d[0] == other.q_._mp_den._mp_d[0]) {
    return mpz_cmp(&q_._mp_num, &other.q_._mp_num);
  }
  return mpq_cmp(&q_, &other.q_);
}

int Rational::compare(const Integer& other) const noexcept {
  return mpq_cmp_z(&q_, &other.z_);
}

int Rational::compare_word(Word other) const noexcept {
  if (other.negative != (sign() < 0)) return other.negative ? 1 : -1;
  mp_limb_t limb = other.size;
  const __mpz_struct word{0, other.negative ? -1 : 1, &limb};
  return is_integer() ? mpz_cmp(&q_._mp_num, &word) : mpq_cmp_z(&q_, &word);
}

bool Rational::equals(const Rational& other) const noexcept {
  return mpq_equal(&q_, &other.q_) != 0;
}

std::string Rational::str() const {
  std::string text = numerator(*this).str();
  if (!is_integer()) text += "/" + denominator(*this).str();
  return text;
}

void Rational::add(const Rational& a, const Rational& b, bool negative) noexcept {
  if (a.is_integer() && b.is_integer()) {
    (negative ? mpz_sub : mpz_add)(&q_._mp_num, &a.q_._mp_num, &b.q_._mp_num);
    set_denominator_to_one();
    return;
  }
  ShortFraction p;
  ShortFraction q;
  if (read_short(&a.q_, p) && read_short(&b.q_, q)) {
    // Only a common factor of both denominators can be a factor of the sum and of its
    // denominator.
    const std::uint64_t common = std::gcd(p.denominator, q.denominator);
    const std::uint64_t rest = q.denominator / common;
    const DoubleWord left = DoubleWord{p.size} * rest;
    const DoubleWord right = DoubleWord{q.size} * (p.denominator / common);
    const bool opposed = p.negative != (q.negative != negative);
    const bool swapped = opposed && left < right;
    const DoubleWord sum = !opposed ? left + right : swapped ? right - left : left - right;
    const std::uint64_t divisor =
        common == 1 ? 1 : std::gcd(static_cast<std::uint64_t>(sum % common), common);
    write(&q_._mp_num, divisor == 1 ? sum : sum / divisor, p.negative != swapped);
    write_denominator(&q_._mp_den, DoubleWord{p.denominator / divisor} * rest);
    return;
  }
  own();
  (negative ? mpq_sub : mpq_add)(&q_, &a.q_, &b.q_);
}

void Rational::multiply(const Rational& a, const Rational& b) noexcept {
  if (a.is_integer() && b.is_integer()) {
    mpz_mul(&q_._mp_num, &a.q_._mp_num, &b.q_._mp_num);
    set_denominator_to_one();
    return;
  }
  ShortFraction p;
  ShortFraction q;
  if (read_short(&a.q_, p) && read_short(&b.q_, q)) {
    write_product(&q_, p, q);
    return;
  }
  own();
  mpq_mul(&q_, &a.q_, &b.q_);
}

void Rational::divide(const Rational& a, const Rational& b) {
  if (b.is_zero()) core_detail::divide_by_zero();
  ShortFraction p;
  ShortFraction q;
  if (read_short(&a.q_, p) && read_short(&b.q_, q)) {
    std::swap(q.size, q.denominator);
    write_product(&q_, p, q);
    return;
  }
  own();
  mpq_div(&q_, &a.q_, &b.q_);
}

Rational& Rational::operator+=(const Rational& b) noexcept {
  add(*this, b, false);
  return *this;
}

Rational& Rational::operator-=(const Rational& b) noexcept {
  add(*this, b, true);
  return *this;
}

Rational& Rational::operator*=(const Rational& b) noexcept {
  multiply(*this, b);
  return *this;
}

Rational& Rational::operator/=(const Rational& b) {
  divide(*this, b);
  return *this;
}

Rational operator+(const Rational& a, const Rational& b) noexcept {
  Rational result;
  result.add(a, b, false);
  return result;
}

Rational operator-(const Rational& a, const Rational& b) noexcept {
  Rational result;
  result.add(a, b, true);
  return result;
}

Rational operator*(const Rational& a, const Rational& b) noexcept {
  Rational result;
  result.multiply(a, b);
  return result;
}

Rational operator/(const Rational& a, const Rational& b) {
  Rational result;
  result.divide(a, b);
  return result;
}

Integer numerator(const Rational& value) noexcept {
  Integer result;
  mpz_set(result.mutable_gmp(), &value.q_._mp_num);
  return result;
}

Integer denominator(const Rational& value) noexcept {
  Integer result;
  mpz_set(result.mutable_gmp(), &value.q_._mp_den);
  return result;
}

std::ostream& operator<<(std::ostream& out, const Rational& value) {
  return out << value.str();
}

}  // namespace stickslip
