// SPDX-License-Identifier: GPL-3.0-or-later
#include "short_arithmetic.hpp"

#include <cstdlib>
#include <numeric>
#include <optional>

namespace stickslip::core_detail {
namespace {

/// A vector (x / scale, y / scale).
struct ShortVector {
  std::int64_t x;
  std::int64_t y;
  std::int64_t scale;
};

/// Returns the vector in this form if x, y and scale are below 2^31; else nothing.
std::optional<ShortVector> short_vector(const Vector2& v) {
  constexpr std::size_t kBits = 31;
  mpq_srcptr x = v.x.gmp();
  mpq_srcptr y = v.y.gmp();
  for (mpz_srcptr part : {mpq_numref(x), mpq_denref(x), mpq_numref(y), mpq_denref(y)}) {
    if (mpz_sizeinbase(part, 2) > kBits) return std::nullopt;
  }
  const std::int64_t scale = std::lcm(mpz_get_si(mpq_denref(x)), mpz_get_si(mpq_denref(y)));
  constexpr std::int64_t kBelow = std::int64_t{1} << kBits;
  const ShortVector result{mpz_get_si(mpq_numref(x)) * (scale / mpz_get_si(mpq_denref(x))),
                           mpz_get_si(mpq_numref(y)) * (scale / mpz_get_si(mpq_denref(y))),
                           scale};
  if (scale >= kBelow || std::abs(result.x) >= kBelow || std::abs(result.y) >= kBelow) {
    return std::nullopt;
  }
  return result;
}

}  // namespace

Rational short_fraction(std::uint64_t numerator, std::uint64_t denominator) {
  const std::uint64_t divisor = std::gcd(numerator, denominator);
  Rational result;
  mpq_set_ui(result.mutable_gmp(), numerator / divisor, denominator / divisor);
  return result;
}

Rational determinant(const Vector2& a, const Vector2& b) {
  const auto p = short_vector(a);
  const auto q = p ? short_vector(b) : std::nullopt;
  if (!q) return a.x * b.y - a.y * b.x;
  const std::int64_t value = p->x * q->y - p->y * q->x;
  Rational result = short_fraction(static_cast<std::uint64_t>(std::abs(value)),
                                   static_cast<std::uint64_t>(p->scale * q->scale));
  if (value < 0) result.negate();
  return result;
}

}  // namespace stickslip::core_detail
