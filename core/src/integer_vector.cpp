// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/integer_vector.hpp"

#include <numeric>
#include <optional>

#include "stickslip/core/error.hpp"

namespace stickslip::core_detail {
namespace {

mpz_srcptr numerator_of(const Rational& value) {
  return mpq_numref(value.gmp());
}

mpz_srcptr denominator_of(const Rational& value) {
  return mpq_denref(value.gmp());
}

/// The numbers that primitive_multiple() needs of all its fractions.
template <class Number>
struct CommonParts {
  Number numerators;    ///< their greatest common divisor; 0 if all are 0
  Number denominators;  ///< their least common multiple
};

/// Returns these numbers if they and the fractions fit into machine words, as they mostly do;
/// else nothing.
std::optional<CommonParts<mp_limb_t>> short_parts(const Rational* a, std::size_t n) {
  CommonParts<mp_limb_t> parts{0, 1};
  for (std::size_t j = 0; j < n; ++j) {
    if (mpz_size(numerator_of(a[j])) > 1 || mpz_size(denominator_of(a[j])) > 1) {
      return std::nullopt;
    }
    const mp_limb_t denominator = mpz_getlimbn(denominator_of(a[j]), 0);
    parts.numerators = std::gcd(parts.numerators, mpz_getlimbn(numerator_of(a[j]), 0));
    if (parts.denominators % denominator == 0) continue;
    const mp_limb_t factor = denominator / std::gcd(parts.denominators, denominator);
    if (__builtin_mul_overflow(parts.denominators, factor, &parts.denominators)) {
      return std::nullopt;
    }
  }
  return parts;
}

CommonParts<Integer> long_parts(const Rational* a, std::size_t n) {
  CommonParts<Integer> parts{0, 1};
  mpz_ptr divisor = parts.numerators.mutable_gmp();
  mpz_ptr common = parts.denominators.mutable_gmp();
  for (std::size_t j = 0; j < n; ++j) {
    mpz_gcd(divisor, divisor, numerator_of(a[j]));
    mpz_lcm(common, common, denominator_of(a[j]));
  }
  return parts;
}

}  // namespace

void make_primitive(Integer* a, std::size_t n) {
  Integer divisor;
  mpz_ptr g = divisor.mutable_gmp();
  for (std::size_t j = 0; j < n; ++j) {
    mpz_gcd(g, g, a[j].gmp());
    if (mpz_cmp_ui(g, 1) == 0) return;
  }
  if (divisor.is_zero()) return;
  for (std::size_t j = 0; j < n; ++j) {
    mpz_divexact(a[j].mutable_gmp(), a[j].gmp(), g);
  }
}

void primitive_multiple(const Rational* a, Integer* result, std::size_t n) {
  // The result for fractions p_j / q_j in lowest terms is (p_j / gcd of all p) (lcm of all q /
  // q_j).
  if (const auto parts = short_parts(a, n)) {
    if (parts->numerators == 0) return;
    for (std::size_t j = 0; j < n; ++j) {
      if (a[j].is_zero()) continue;
      mpz_ptr entry = result[j].mutable_gmp();
      const mp_limb_t numerator = mpz_getlimbn(numerator_of(a[j]), 0) / parts->numerators;
      const mp_limb_t factor = parts->denominators / mpz_getlimbn(denominator_of(a[j]), 0);
      mp_limb_t product = 0;
      if (__builtin_mul_overflow(numerator, factor, &product)) {
        mpz_set_ui(entry, numerator);
        mpz_mul_ui(entry, entry, factor);
      } else {
        mpz_set_ui(entry, product);
      }
      if (a[j].sign() < 0) mpz_neg(entry, entry);
    }
    return;
  }
  const CommonParts<Integer> parts = long_parts(a, n);
  Integer factor;
  for (std::size_t j = 0; j < n; ++j) {
    if (a[j].is_zero()) continue;
    mpz_ptr entry = result[j].mutable_gmp();
    mpz_divexact(entry, numerator_of(a[j]), parts.numerators.gmp());
    mpz_divexact(factor.mutable_gmp(), parts.denominators.gmp(), denominator_of(a[j]));
    mpz_mul(entry, entry, factor.gmp());
  }
}

void round_to_one(const Integer* a, double* result, std::size_t n) {
  constexpr long kVanishes = 2000;
  std::array<long, 64> exponents;
  require(n <= exponents.size(), "a vector has few entries");
  std::optional<long> largest;
  for (std::size_t j = 0; j < n; ++j) {
    result[j] = mpz_get_d_2exp(&exponents[j], a[j].gmp());
    if (result[j] != 0) largest = std::max(largest.value_or(exponents[j]), exponents[j]);
  }
  for (std::size_t j = 0; j < n; ++j) {
    if (result[j] == 0) continue;
    const long shift = std::max(exponents[j] - *largest, -kVanishes);
    result[j] = std::ldexp(result[j], static_cast<int>(shift));
  }
}

}  // namespace stickslip::core_detail
