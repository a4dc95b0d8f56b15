// SPDX-License-Identifier: GPL-3.0-or-later
#include "scaled_system.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "small_integer.hpp"

namespace stickslip::lp_detail {
namespace {

bool is_nonzero(const std::vector<Rational>& values) {
  return std::any_of(values.begin(), values.end(),
                     [](const Rational& value) { return !value.is_zero(); });
}

/// Scales numerators[k] / denominators[k] to coprime integers by one positive factor, in place.
/// Returns false when 64 bits do not suffice.
bool make_coprime_small(std::vector<std::int64_t>& numerators,
                        const std::vector<std::int64_t>& denominators) {
  std::int64_t multiple = 1;
  for (const std::int64_t denominator : denominators) {
    if (denominator == 1) continue;
    const std::int64_t step = denominator / std::gcd(multiple, denominator);
    if (__builtin_mul_overflow(multiple, step, &multiple)) return false;
  }
  if (multiple != 1) {
    for (std::size_t k = 0; k < numerators.size(); ++k) {
      const std::int64_t step = multiple / denominators[k];
      if (__builtin_mul_overflow(numerators[k], step, &numerators[k])) return false;
    }
  }
  std::int64_t divisor = 0;
  for (const std::int64_t value : numerators) {
    if (divisor == 1) break;
    if (value == std::numeric_limits<std::int64_t>::min()) return false;
    divisor = std::gcd(divisor, value);
  }
  if (divisor > 1) {
    for (std::int64_t& value : numerators) value /= divisor;
  }
  return true;
}

/// Returns mantissa * 2^(exponent - reference), without the traps of a huge exponent.
double scaled_double(double mantissa, long exponent, long reference) {
  const long shift = std::clamp(exponent - reference, -4000L, 4000L);
  return std::ldexp(mantissa, static_cast<int>(shift));
}

/// Multiplies by a factor. Most factors are 1 or -1, which need no gcd.
void multiply(Rational& value, const Rational& factor) {
  if (factor == 1) return;
  if (factor == -1) {
    value.negate();
  } else {
    value *= factor;
  }
}

/// Replaces `values` by their positive multiple that is a vector of coprime integers.
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

}  // namespace

ScaledSystem::ScaledSystem(const LinearProgram& program)
    : program_(program),
      n_(static_cast<Index>(program.variable_count())),
      m_(static_cast<Index>(program.row_count())),
      has_objective_(is_nonzero(program.objective())) {
  domains_.reserve(std::size_t{n_} + m_);
  for (Index j = 0; j < n_; ++j) {
    domains_.push_back(program.kind(j) == VariableKind::kFree ? Domain::kFree
                                                              : Domain::kNonNegative);
  }
  small_.reserve((std::size_t{n_} + 1) * (std::size_t{m_} + 1));
  std::vector<std::int64_t> numerators(std::size_t{n_} + 1);
  std::vector<std::int64_t> denominators(std::size_t{n_} + 1);
  const auto add = [&](const std::vector<Rational>& coefficients, const Rational* rhs,
                       bool flip) {
    if (is_small()) {
      bool fits = true;
      for (std::size_t j = 0; j <= n_; ++j) {
        const Rational* value = j == n_                   ? rhs
                                : j < coefficients.size() ? &coefficients[j]
                                                          : nullptr;
        numerators[j] = 0;
        denominators[j] = 1;
        if (value == nullptr) continue;
        fits = fits && read_small(numerator_of(*value), numerators[j]) &&
               read_small(denominator_of(*value), denominators[j]);
      }
      if (fits && make_coprime_small(numerators, denominators)) {
        if (flip) {
          for (std::size_t j = 0; j < n_; ++j) numerators[j] = -numerators[j];
        } else {
          numerators[n_] = -numerators[n_];
        }
        small_.insert(small_.end(), numerators.begin(), numerators.end());
        return;
      }
      big_.reserve(small_.capacity());
      big_.assign(small_.begin(), small_.end());
    }
    add_big_row(coefficients, rhs, flip);
  };
  for (Index i = 0; i < m_; ++i) {
    const LpRow& row = program.row(i);
    domains_.push_back(row.relation == Relation::kEqual ? Domain::kZero : Domain::kNonNegative);
    add(row.coefficients, &row.rhs, row.relation == Relation::kLessEqual);
  }
  if (has_objective_) add(program.objective(), nullptr, false);
}

void ScaledSystem::add_big_row(const std::vector<Rational>& coefficients, const Rational* rhs,
                               bool flip) {
  Integer multiple = 1;
  Integer divisor = 0;
  const auto visit = [&](const Rational& value) {
    multiple = lcm(multiple, denominator(value));
    divisor = gcd(divisor, numerator(value));
  };
  for (const Rational& value : coefficients) visit(value);
  if (rhs != nullptr) visit(*rhs);
  // The fractions are in lowest terms, so multiple / divisor is exactly the factor that makes
  // them coprime integers.
  const auto push = [&](const Rational* value, bool negate) {
    big_.emplace_back(0);
    if (value == nullptr || value->is_zero()) return;
    big_.back() = numerator(*value) / divisor * (multiple / denominator(*value));
    if (negate) big_.back() = -big_.back();
  };
  for (std::size_t j = 0; j < n_; ++j) {
    push(j < coefficients.size() ? &coefficients[j] : nullptr, flip);
  }
  push(rhs, !flip);
}

Rational ScaledSystem::factor(Index row) const {
  const std::vector<Rational>& coefficients =
      row < m_ ? program_.row(row).coefficients : program_.objective();
  const auto entry = [&](Index column) {
    return is_small() ? Rational(small(row, column)) : Rational(big(row, column));
  };
  for (Index j = 0; j < coefficients.size(); ++j) {
    if (coefficients[j].is_zero()) continue;
    std::int64_t given = 0;  // most rows come as coprime integers
    if (is_small() && mpz_cmp_ui(denominator_of(coefficients[j]), 1) == 0 &&
        read_small(numerator_of(coefficients[j]), given) &&
        (given == small(row, j) || given == -small(row, j))) {
      return given == small(row, j) ? 1 : -1;
    }
    return entry(j) / coefficients[j];
  }
  if (row < m_ && !program_.row(row).rhs.is_zero()) return -entry(n_) / program_.row(row).rhs;
  return 1;
}

void ScaledSystem::approximate_row(Index row, double* constant_then_coefficients) const {
  double* const out = constant_then_coefficients;
  if (is_small()) {
    const std::int64_t* const values = &small_[std::size_t{row} * (std::size_t{n_} + 1)];
    double largest = 0;
    for (Index j = 0; j < n_; ++j) {
      largest = std::max(largest, std::abs(static_cast<double>(values[j])));
    }
    const double scale = largest > 0 ? 1 / largest : 1;
    out[0] = static_cast<double>(values[n_]) * scale;
    for (Index j = 0; j < n_; ++j) out[j + 1] = static_cast<double>(values[j]) * scale;
    return;
  }
  const auto split = [&](Index column, long& exponent) {
    return mpz_get_d_2exp(&exponent, big(row, column).gmp());
  };
  long reference = std::numeric_limits<long>::min();
  long exponent = 0;
  for (Index j = 0; j < n_; ++j) {
    if (split(j, exponent) != 0) reference = std::max(reference, exponent);
  }
  if (reference == std::numeric_limits<long>::min()) split(n_, reference);
  for (Index j = 0; j <= n_; ++j) {
    const double mantissa = split(j, exponent);
    out[j == n_ ? 0 : j + 1] = scaled_double(mantissa, exponent, reference);
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
