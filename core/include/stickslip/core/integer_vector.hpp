// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Vectors of integers: directions and planes, where only the ratios matter.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "stickslip/core/number.hpp"

namespace stickslip {

namespace core_detail {

/// Divides n integers by their greatest common divisor, in place (primitive()).
void make_primitive(Integer* a, std::size_t n);
/// Writes primitive_multiple() of n fractions to `result`, which is 0 before.
void primitive_multiple(const Rational* a, Integer* result, std::size_t n);
/// Writes in_doubles() of n integers to `result`.
void round_to_one(const Integer* a, double* result, std::size_t n);

}  // namespace core_detail

/// A vector of n integers.
template <std::size_t n>
using IntegerVector = std::array<Integer, n>;
/// A vector of three integers: a plane by its normal, or a motion up to a positive factor, in
/// coordinates (x, y, r).
using IntegerVector3 = IntegerVector<3>;
/// \{ The coefficients of a linear function of x = (d_x, d_y, d_r, h, l) in the plane, or a
/// point x itself.
using IntegerVector5 = IntegerVector<5>;
using Vector5 = std::array<Rational, 5>;
/// \}

/// Returns the sum of a_j b_j, for numbers of any kind.
template <class Number, std::size_t n>
Number dot(const std::array<Number, n>& a, const std::array<Number, n>& b) {
  Number sum = 0;
  for (std::size_t j = 0; j < n; ++j) sum += a[j] * b[j];
  return sum;
}

/// Returns the sum of a_j b_j for integers, without a temporary for each product.
template <std::size_t n>
Integer dot(const IntegerVector<n>& a, const IntegerVector<n>& b) {
  Integer sum;
  for (std::size_t j = 0; j < n; ++j) {
    mpz_addmul(sum.mutable_gmp(), a[j].gmp(), b[j].gmp());
  }
  return sum;
}

/// Returns a x b, right-handed: (1, 0, 0) x (0, 1, 0) = (0, 0, 1).
template <class Number>
std::array<Number, 3> cross(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Returns whether every entry is 0.
template <std::size_t n>
bool is_zero(const IntegerVector<n>& a) {
  for (const Integer& entry : a) {
    if (!entry.is_zero()) return false;
  }
  return true;
}

/// Returns -a.
template <std::size_t n>
IntegerVector<n> negated(IntegerVector<n> a) {
  for (Integer& entry : a) entry = -entry;
  return a;
}

/// Returns a divided by the greatest common divisor of its entries; 0 stays 0.
template <std::size_t n>
IntegerVector<n> primitive(IntegerVector<n> a) {
  core_detail::make_primitive(a.data(), n);
  return a;
}

/// Returns the primitive integer vector that is a positive multiple of `a`; 0 stays 0.
template <std::size_t n>
IntegerVector<n> primitive_multiple(const std::array<Rational, n>& a) {
  IntegerVector<n> result;
  core_detail::primitive_multiple(a.data(), result.data(), n);
  return result;
}

/// Returns the primitive integer vector nearest to a multiple of `a` whose entries have about
/// this many bits; 0 for 0 and if an entry is not finite.
template <std::size_t n>
IntegerVector<n> in_bits(const std::array<double, n>& a, int bits) {
  double largest = 0;
  bool finite = true;
  for (const double entry : a) {
    largest = std::max(largest, std::fabs(entry));
    finite = finite && std::isfinite(entry);
  }
  IntegerVector<n> result{};
  if (!finite || !(largest > 0)) return result;
  for (std::size_t j = 0; j < n; ++j) {
    result[j] = std::llround(std::ldexp(a[j] / largest, bits));
  }
  return primitive(std::move(result));
}

/// Returns a over a power of two such that the largest entry is between 1/2 and 1. So neither
/// squares nor sums of products overflow, however long the entries are. Each entry is off by at
/// most two unit roundoffs, or by 2^-1073 where it is so small beside the largest that it
/// underflows. Entries of at most 53 bits are exact; 0 stays 0.
template <std::size_t n>
std::array<double, n> in_doubles(const IntegerVector<n>& a) {
  std::array<double, n> result;
  core_detail::round_to_one(a.data(), result.data(), n);
  return result;
}

}  // namespace stickslip
