// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <ostream>

#include "divide_by_zero.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/number.hpp"

namespace stickslip {

using core_detail::Word;

Integer::Integer(double value) : Integer() {
  if (!std::isfinite(value)) throw std::overflow_error("Not a finite number.");
  mpz_set_d(&z_, value);
}

Integer::Integer(const Rational& value) : Integer() {
  mpz_tdiv_q(&z_, mpq_numref(value.gmp()), mpq_denref(value.gmp()));
}

Integer::Integer(const std::string& digits) : Integer() {
  if (digits.find_first_not_of("-0123456789") != std::string::npos ||
      mpz_set_str(&z_, digits.c_str(), 10) != 0) {
    if (z_._mp_alloc != 0) mpz_clear(&z_);
    throw std::invalid_argument(quote(digits) + " is no integer");
  }
}

std::string Integer::str() const {
  std::string text(mpz_sizeinbase(&z_, 10) + 2, '\0');  // room for a sign and an end
  mpz_get_str(text.data(), 10, &z_);
  text.resize(std::strlen(text.c_str()));
  return text;
}

void Integer::set(const Integer& value) noexcept {
  mpz_set(&z_, &value.z_);
}

void Integer::set(Word value) noexcept {
  mpz_set_ui(&z_, value.size);
  if (value.negative) negate();
}

void Integer::add(const Integer& a, Word b) noexcept {
  if (b.negative) {
    mpz_sub_ui(&z_, &a.z_, b.size);
  } else {
    mpz_add_ui(&z_, &a.z_, b.size);
  }
}

void Integer::subtract(const Integer& a, Word b) noexcept {
  b.negative = !b.negative;
  add(a, b);
}

void Integer::multiply(const Integer& a, Word b) noexcept {
  mpz_mul_ui(&z_, &a.z_, b.size);
  if (b.negative) negate();
}

int Integer::compare_word(Word other) const noexcept {
  if (other.negative != (sign() < 0)) return other.negative ? 1 : -1;
  const int sizes = mpz_cmpabs_ui(&z_, other.size);
  return other.negative ? -sizes : sizes;
}

long Integer::to_long() const {
  if (mpz_fits_slong_p(&z_) == 0) too_long();
  return mpz_get_si(&z_);
}

unsigned long Integer::to_unsigned_long() const {
  if (mpz_fits_ulong_p(&z_) == 0) too_long();
  return mpz_get_ui(&z_);
}

void Integer::too_long() {
  throw std::overflow_error("An integer is too long for a word.");
}

Integer& Integer::operator+=(const Integer& b) noexcept {
  mpz_add(&z_, &z_, &b.z_);
  return *this;
}

Integer& Integer::operator-=(const Integer& b) noexcept {
  mpz_sub(&z_, &z_, &b.z_);
  return *this;
}

Integer& Integer::operator*=(const Integer& b) noexcept {
  mpz_mul(&z_, &z_, &b.z_);
  return *this;
}

Integer& Integer::operator/=(const Integer& b) {
  if (b.is_zero()) core_detail::divide_by_zero();
  mpz_tdiv_q(&z_, &z_, &b.z_);
  return *this;
}

Integer& Integer::operator%=(const Integer& b) {
  if (b.is_zero()) core_detail::divide_by_zero();
  mpz_tdiv_r(&z_, &z_, &b.z_);
  return *this;
}

Integer& Integer::operator<<=(unsigned long bits) noexcept {
  mpz_mul_2exp(&z_, &z_, bits);
  return *this;
}

Integer& Integer::operator>>=(unsigned long bits) noexcept {
  mpz_fdiv_q_2exp(&z_, &z_, bits);
  return *this;
}

Integer operator+(const Integer& a, const Integer& b) noexcept {
  Integer result;
  mpz_add(&result.z_, &a.z_, &b.z_);
  return result;
}

Integer operator-(const Integer& a, const Integer& b) noexcept {
  Integer result;
  mpz_sub(&result.z_, &a.z_, &b.z_);
  return result;
}

Integer operator*(const Integer& a, const Integer& b) noexcept {
  Integer result;
  mpz_mul(&result.z_, &a.z_, &b.z_);
  return result;
}

Integer operator/(const Integer& a, const Integer& b) {
  if (b.is_zero()) core_detail::divide_by_zero();
  Integer result;
  mpz_tdiv_q(&result.z_, &a.z_, &b.z_);
  return result;
}

Integer operator%(const Integer& a, const Integer& b) {
  if (b.is_zero()) core_detail::divide_by_zero();
  Integer result;
  mpz_tdiv_r(&result.z_, &a.z_, &b.z_);
  return result;
}

Integer operator<<(const Integer& a, unsigned long bits) noexcept {
  Integer result;
  mpz_mul_2exp(&result.z_, &a.z_, bits);
  return result;
}

Integer operator>>(const Integer& a, unsigned long bits) noexcept {
  Integer result;
  mpz_fdiv_q_2exp(&result.z_, &a.z_, bits);
  return result;
}

Integer operator&(const Integer& a, const Integer& b) noexcept {
  Integer result;
  mpz_and(&result.z_, &a.z_, &b.z_);
  return result;
}

Integer gcd(const Integer& a, const Integer& b) noexcept {
  Integer result;
  mpz_gcd(result.mutable_gmp(), a.gmp(), b.gmp());
  return result;
}

Integer lcm(const Integer& a, const Integer& b) noexcept {
  Integer result;
  mpz_lcm(result.mutable_gmp(), a.gmp(), b.gmp());
  return result;
}

Integer pow(const Integer& base, unsigned exponent) noexcept {
  Integer result;
  mpz_pow_ui(result.mutable_gmp(), base.gmp(), exponent);
  return result;
}

Integer sqrt(const Integer& value) {
  require(value.sign() >= 0, "sqrt of a negative integer");
  Integer result;
  mpz_sqrt(result.mutable_gmp(), value.gmp());
  return result;
}

std::size_t msb(const Integer& value) {
  require(value.sign() > 0, "msb of an integer that is not positive");
  return mpz_sizeinbase(value.gmp(), 2) - 1;
}

std::ostream& operator<<(std::ostream& out, const Integer& value) {
  return out << value.str();
}

}  // namespace stickslip
