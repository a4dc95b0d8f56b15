// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence.hpp"

#include <numeric>
#include <utility>

namespace stickslip::lp_detail {
namespace {

/// Most factors are 1 or -1, which need no gcd.
void multiply(Rational& value, const Rational& factor) {
  if (factor == 1) return;
  if (factor == -1) {
    mpq_neg(value.backend().data(), value.backend().data());
  } else {
    value *= factor;
  }
}

}  // namespace

Rational ratio(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t divisor = std::gcd(numerator, denominator);
  const std::int64_t signed_divisor = denominator < 0 ? -divisor : divisor;
  Rational out;
  mpq_set_si(out.backend().data(), numerator / signed_divisor,
             static_cast<unsigned long>(denominator / signed_divisor));
  return out;
}

Rational ratio(Int128 numerator, Int128 denominator) {
  return ratio(Int128Tier::to_integer(numerator), Int128Tier::to_integer(denominator));
}

Rational ratio(const Integer& numerator, const Integer& denominator) {
  return {numerator, denominator};
}

void make_coprime(std::vector<Rational>& values) {
  Integer multiple = 1;
  Integer divisor = 0;
  for (const Rational& value : values) {
    if (value.is_zero()) continue;
    multiple = lcm(multiple, denominator(value));
    divisor = gcd(divisor, numerator(value));
  }
  if (divisor.is_zero() || (multiple == 1 && divisor == 1)) return;
  const Rational factor(multiple, divisor);
  for (Rational& value : values) {
    if (!value.is_zero()) value *= factor;
  }
}

Optimal make_optimal(const LinearProgram& program, const ScaledSystem& system,
                     std::vector<Rational> point, std::vector<Rational> multipliers) {
  Optimal out;
  out.point = std::move(point);
  out.dual = std::move(multipliers);
  out.dual.resize(system.row_count());
  if (!system.has_objective()) return out;
  const std::vector<Rational>& objective = program.objective();
  for (std::size_t j = 0; j < objective.size(); ++j) {
    if (!objective[j].is_zero()) out.value += objective[j] * out.point[j];
  }
  const Rational objective_factor = system.factor(system.row_count());
  for (Index i = 0; i < system.row_count(); ++i) {
    if (!out.dual[i].is_zero()) multiply(out.dual[i], system.factor(i) / objective_factor);
  }
  return out;
}

Infeasible make_infeasible(const ScaledSystem& system, std::vector<Rational> multipliers) {
  Infeasible out;
  out.farkas = std::move(multipliers);
  for (Index i = 0; i < system.row_count(); ++i) {
    if (!out.farkas[i].is_zero()) multiply(out.farkas[i], system.factor(i));
  }
  make_coprime(out.farkas);
  return out;
}

Unbounded make_unbounded(std::vector<Rational> point, std::vector<Rational> ray) {
  make_coprime(ray);
  return {std::move(point), std::move(ray)};
}

}  // namespace stickslip::lp_detail
