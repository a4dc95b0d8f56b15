// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every condition here is the sign of sum u_k v_k for two rational vectors. Each vector is
// brought to integers over a common positive denominator once, and then signs are those of
// integer sums: in 64 x 64 -> 128 bits when all fits (each addition checked), else with GMP.
#include "stickslip/lp/verify.hpp"

#include <numeric>
#include <variant>
#include <vector>

#include "small_integer.hpp"

namespace stickslip {
namespace {

__extension__ typedef __int128 Int128;

/// A rational vector of fixed length as integers over one positive denominator.
class IntegerVector {
 public:
  /// Loads (values, zeros up to `length`, last).
  void load(const std::vector<Rational>& values, std::size_t length, const Rational& last) {
    length_ = length + 1;
    is_small_ = load_small(values, last);
    if (!is_small_) load_big(values, last);
  }

  std::size_t length() const { return length_; }
  bool is_small() const { return is_small_; }
  std::int64_t small(std::size_t k) const { return small_[k]; }
  Integer big(std::size_t k) const { return is_small_ ? Integer(small_[k]) : big_[k]; }
  Integer denominator() const { return is_small_ ? Integer(small_denominator_) : denominator_; }
  /// Returns an entry. Requires !is_small().
  const Integer& big_entry(std::size_t k) const { return big_[k]; }
  bool is_integral() const { return is_small_ ? small_denominator_ == 1 : denominator_ == 1; }

  /// Adds factor * entry k to sum, without a temporary.
  void add_multiple(std::size_t k, const Integer& factor, Integer& sum) const {
    mpz_ptr to = sum.mutable_gmp();
    mpz_srcptr by = factor.gmp();
    if (!is_small_) {
      mpz_addmul(to, by, big_[k].gmp());
    } else if (small_[k] >= 0) {
      mpz_addmul_ui(to, by, static_cast<std::uint64_t>(small_[k]));
    } else {
      mpz_submul_ui(to, by, -static_cast<std::uint64_t>(small_[k]));
    }
  }

 private:
  bool load_small(const std::vector<Rational>& values, const Rational& last) {
    small_.assign(length_, 0);
    divisors_.assign(length_, 1);
    const auto read = [&](const Rational& value, std::size_t k) {
      return lp_detail::read_small(lp_detail::numerator_of(value), small_[k]) &&
             lp_detail::read_small(lp_detail::denominator_of(value), divisors_[k]);
    };
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!read(values[k], k)) return false;
    }
    if (!read(last, length_ - 1)) return false;
    small_denominator_ = 1;
    for (const std::int64_t divisor : divisors_) {
      if (divisor == 1 || small_denominator_ % divisor == 0) continue;
      const std::int64_t step = divisor / std::gcd(small_denominator_, divisor);
      if (__builtin_mul_overflow(small_denominator_, step, &small_denominator_)) return false;
    }
    if (small_denominator_ == 1) return true;
    for (std::size_t k = 0; k < length_; ++k) {
      const std::int64_t step = small_denominator_ / divisors_[k];
      if (__builtin_mul_overflow(small_[k], step, &small_[k])) return false;
    }
    return true;
  }

  void load_big(const std::vector<Rational>& values, const Rational& last) {
    denominator_ = stickslip::denominator(last);
    for (const Rational& value : values) {
      denominator_ = lcm(denominator_, stickslip::denominator(value));
    }
    big_.assign(length_, Integer(0));
    const auto write = [&](const Rational& value, std::size_t k) {
      if (value.is_zero()) return;
      big_[k] = stickslip::numerator(value) * (denominator_ / stickslip::denominator(value));
    };
    for (std::size_t k = 0; k < values.size(); ++k) write(values[k], k);
    write(last, length_ - 1);
  }

  std::size_t length_ = 0;
  bool is_small_ = true;
  std::vector<std::int64_t> small_;
  std::vector<std::int64_t> divisors_;
  std::int64_t small_denominator_ = 1;
  std::vector<Integer> big_;
  Integer denominator_ = 1;
};

/// Adds a b to sum. Returns false on overflow.
bool add_product(Int128& sum, std::int64_t a, std::int64_t b) {
  return !__builtin_add_overflow(sum, static_cast<Int128>(a) * b, &sum);
}

int sign_of_dot(const IntegerVector& u, const IntegerVector& v) {
  if (u.is_small() && v.is_small()) {
    Int128 sum = 0;
    bool fits = true;
    for (std::size_t k = 0; k < u.length(); ++k) {
      fits = add_product(sum, u.small(k), v.small(k)) && fits;
    }
    if (fits) return sum < 0 ? -1 : sum > 0 ? 1 : 0;
  }
  Integer sum = 0;
  if (v.is_small()) {
    for (std::size_t k = 0; k < u.length(); ++k) v.add_multiple(k, u.big(k), sum);
  } else {
    for (std::size_t k = 0; k < u.length(); ++k) u.add_multiple(k, v.big_entry(k), sum);
  }
  return sum.sign();
}

bool relation_holds(int sign, Relation relation) {
  switch (relation) {
    case Relation::kLessEqual:
      return sign <= 0;
    case Relation::kEqual:
      return sign == 0;
    case Relation::kGreaterEqual:
      return sign >= 0;
  }
  return false;
}

Verification fails(LpCondition condition, std::size_t index = 0) {
  return {false, condition, index};
}

/// Checks that x satisfies all rows, with right-hand sides multiplied by `scale` (1: a point,
/// 0: a ray).
Verification check_primal(const LinearProgram& program, const std::vector<Rational>& x,
                          int scale, LpCondition sign_condition, LpCondition row_condition) {
  const std::size_t n = program.variable_count();
  if (x.size() != n) return fails(LpCondition::kLength);
  for (std::size_t j = 0; j < n; ++j) {
    if (program.kind(j) == VariableKind::kNonNegative && x[j].sign() < 0) {
      return fails(sign_condition, j);
    }
  }
  IntegerVector point;
  point.load(x, n, Rational(-scale));
  IntegerVector row;
  for (std::size_t i = 0; i < program.row_count(); ++i) {
    row.load(program.row(i).coefficients, n, program.row(i).rhs);
    if (!relation_holds(sign_of_dot(row, point), program.row(i).relation)) {
      return fails(row_condition, i);
    }
  }
  return {};
}

/// The signs of sum_i y_i (a_i, b_i) - (c, value), up to one positive factor. The second part
/// is there only if `value` is given.
class Combination {
 public:
  Combination(const LinearProgram& program, const std::vector<Rational>& y,
              const Rational* value)
      : n_(program.variable_count()) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      if (!y[i].is_zero()) add(program.row(i).coefficients, program.row(i).rhs, y[i]);
    }
    if (value != nullptr) add(program.objective(), *value, Rational(-1));
    sum_up();
  }

  /// Returns the sign in a column; column n is that of the right-hand sides.
  int sign(std::size_t column) const { return signs_[column]; }

 private:
  struct Term {
    const std::vector<Rational>* coefficients;
    const Rational* rhs;
  };

  void add(const std::vector<Rational>& coefficients, const Rational& rhs, const Rational& y) {
    // The coefficients a are loaded as integers A = R a, so the term y a is (y / R) A.
    row_.load(coefficients, n_, rhs);
    terms_.push_back({&coefficients, &rhs});
    weights_.push_back(row_.is_integral() ? y : Rational(y / Rational(row_.denominator())));
  }

  void sum_up() {
    IntegerVector weights;
    weights.load(weights_, weights_.size(), Rational(0));
    signs_.resize(n_ + 1);
    if (sum_up_small(weights)) return;
    std::vector<Integer> sums(n_ + 1);
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      row_.load(*terms_[t].coefficients, n_, *terms_[t].rhs);
      const Integer weight = weights.big(t);
      for (std::size_t j = 0; j <= n_; ++j) row_.add_multiple(j, weight, sums[j]);
    }
    for (std::size_t j = 0; j <= n_; ++j) signs_[j] = sums[j].sign();
  }

  bool sum_up_small(const IntegerVector& weights) {
    if (!weights.is_small()) return false;
    std::vector<Int128> sums(n_ + 1, 0);
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      row_.load(*terms_[t].coefficients, n_, *terms_[t].rhs);
      if (!row_.is_small()) return false;
      for (std::size_t j = 0; j <= n_; ++j) {
        if (!add_product(sums[j], weights.small(t), row_.small(j))) return false;
      }
    }
    for (std::size_t j = 0; j <= n_; ++j) signs_[j] = sums[j] < 0 ? -1 : sums[j] > 0 ? 1 : 0;
    return true;
  }

  std::size_t n_;
  IntegerVector row_;
  std::vector<Term> terms_;
  std::vector<Rational> weights_;
  std::vector<int> signs_;
};

/// Checks that y is admissible, and that yA - c (c only if `value` is given) is 0 for free
/// variables and <= 0 for variables >= 0. Then `rhs_sign` is the sign of y.b - value.
Verification check_dual(const LinearProgram& program, const std::vector<Rational>& y,
                        const Rational* value, int& rhs_sign) {
  if (y.size() != program.row_count()) return fails(LpCondition::kLength);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const Relation relation = program.row(i).relation;
    if (relation != Relation::kEqual && !relation_holds(y[i].sign(), relation)) {
      return fails(LpCondition::kMultiplierSign, i);
    }
  }
  const Combination combination(program, y, value);
  for (std::size_t j = 0; j < program.variable_count(); ++j) {
    const bool holds = program.kind(j) == VariableKind::kFree ? combination.sign(j) == 0
                                                              : combination.sign(j) <= 0;
    if (!holds) return fails(LpCondition::kCombination, j);
  }
  rhs_sign = combination.sign(program.variable_count());
  return {};
}

/// Returns the sign of c.x - value.
int objective_sign(const LinearProgram& program, const std::vector<Rational>& x,
                   const Rational& value) {
  IntegerVector objective;
  objective.load(program.objective(), program.variable_count(), value);
  IntegerVector point;
  point.load(x, program.variable_count(), Rational(-1));
  return sign_of_dot(objective, point);
}

}  // namespace

Verification verify(const LinearProgram& program, const Optimal& evidence) {
  const Verification primal =
      check_primal(program, evidence.point, 1, LpCondition::kPointSign, LpCondition::kPointRow);
  if (!primal) return primal;
  int rhs_sign = 0;
  const Verification dual = check_dual(program, evidence.dual, &evidence.value, rhs_sign);
  if (!dual) return dual;
  if (objective_sign(program, evidence.point, evidence.value) != 0) {
    return fails(LpCondition::kPointValue);
  }
  if (rhs_sign != 0) return fails(LpCondition::kDualValue);
  return {};
}

Verification verify(const LinearProgram& program, const Infeasible& evidence) {
  int rhs_sign = 0;
  const Verification dual = check_dual(program, evidence.farkas, nullptr, rhs_sign);
  if (!dual) return dual;
  if (rhs_sign <= 0) return fails(LpCondition::kContradiction);
  return {};
}

Verification verify(const LinearProgram& program, const Unbounded& evidence) {
  const Verification primal =
      check_primal(program, evidence.point, 1, LpCondition::kPointSign, LpCondition::kPointRow);
  if (!primal) return primal;
  const Verification ray =
      check_primal(program, evidence.ray, 0, LpCondition::kRaySign, LpCondition::kRayRow);
  if (!ray) return ray;
  if (objective_sign(program, evidence.ray, Rational(0)) >= 0) {
    return fails(LpCondition::kRayDescent);
  }
  return {};
}

Verification verify(const LinearProgram& program, const LpResult& result) {
  return std::visit([&](const auto& evidence) { return verify(program, evidence); }, result);
}

}  // namespace stickslip
