// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a proposed basis to exact evidence.
//
// The nonbasic slacks give k rows I and the basic x_j give k columns J. With the other x_j at
// 0, the point solves G_IJ x_J = -h_I, the multipliers y G_IJ = (objective or witness row)_J,
// the ray G_IJ d_J = (entering column)_I: at most two k x k systems, solved by fraction-free
// Gauss-Jordan elimination (Bareiss 1968) in O(k^3).
#include <algorithm>
#include <utility>

#include "integer_tier.hpp"
#include "steps.hpp"
#include "stickslip/lp/verify.hpp"

namespace stickslip::lp_detail {
namespace {

enum class Outcome { kDone, kSingular, kOverflow };

/// A square system with one right-hand side, A z = r, solved as z = numerators / denominator.
template <class Tier>
class SquareSystem {
 public:
  using Value = typename Tier::Value;

  explicit SquareSystem(std::size_t size)
      : size_(size), width_(size + 1), cells_(size * (size + 1)) {}

  /// The entry in this row and column; column size() is the right-hand side.
  Value& at(std::size_t row, std::size_t column) { return cells_[row * width_ + column]; }
  std::size_t size() const { return size_; }

  /// Solves the system. After step s, columns 0..s are p times the identity, p is the
  /// determinant of the leading block, and the other entries are minors (Bareiss 1968).
  Outcome solve(typename Tier::BitMeter& meter) {
    denominator_ = 1;
    Value factor;
    for (std::size_t s = 0; s < size_; ++s) {
      std::size_t found = s;
      while (found < size_ && Tier::sign(at(found, s)) == 0) ++found;
      if (found == size_) return Outcome::kSingular;
      if (found != s) {
        std::swap_ranges(&at(found, s), &at(found, s) + (width_ - s), &at(s, s));
      }
      const typename Tier::Divisor divisor(denominator_);
      const Value* const pivot_row = &at(s, 0);
      const Value& pivot = pivot_row[s];
      meter.note(pivot);
      for (std::size_t i = 0; i < size_; ++i) {
        if (i == s) continue;
        Value* const row = &at(i, 0);
        factor = row[s];
        for (std::size_t j = s + 1; j < width_; ++j) {
          if (!Tier::fused(row[j], pivot, factor, pivot_row[j], divisor, row[j])) {
            return Outcome::kOverflow;
          }
          meter.note(row[j]);
        }
      }
      denominator_ = pivot;
    }
    return Outcome::kDone;
  }

  const Value& denominator() const { return denominator_; }
  const Value& numerator(std::size_t k) { return at(k, size_); }

 private:
  std::size_t size_;
  std::size_t width_;
  std::vector<Value> cells_;
  Value denominator_{};
};

template <class Tier>
class Confirmation {
 public:
  using Value = typename Tier::Value;

  Confirmation(const LinearProgram& program, const ScaledSystem& system,
               const Proposal& proposal)
      : program_(program), system_(system), proposal_(proposal) {
    const Index n = system.variable_count();
    std::vector<bool> is_nonbasic(n);
    for (const Index variable : proposal.nonbasic) {
      if (variable < n) {
        is_nonbasic[variable] = true;
      } else {
        rows_.push_back(variable - n);
      }
    }
    for (Index j = 0; j < n; ++j) {
      if (!is_nonbasic[j]) columns_.push_back(j);
    }
  }

  Outcome run() {
    switch (proposal_.kind) {
      case Proposal::Kind::kOptimal:
        return run_optimal();
      case Proposal::Kind::kInfeasible:
        return run_infeasible();
      case Proposal::Kind::kUnbounded:
        return run_unbounded();
      case Proposal::Kind::kNone:
        break;
    }
    return Outcome::kSingular;
  }

  LpResult take_result() { return std::move(result_); }
  long bits() const { return meter_.bits(); }

 private:
  std::size_t size() const { return rows_.size(); }

  /// Solves G_IJ z = r (or its transpose), r given by right_hand_side(k, to).
  template <class RightHandSide>
  Outcome solve(SquareSystem<Tier>& square, bool transposed, RightHandSide right_hand_side) {
    for (std::size_t a = 0; a < size(); ++a) {
      for (std::size_t b = 0; b < size(); ++b) {
        Value& to = transposed ? square.at(b, a) : square.at(a, b);
        if (!system_.load<Tier>(rows_[a], columns_[b], to)) return Outcome::kOverflow;
        meter_.note(to);
      }
      if (!right_hand_side(a, square.at(a, size()))) return Outcome::kOverflow;
    }
    return square.solve(meter_);
  }

  Outcome solve_point(std::vector<Rational>& point) {
    SquareSystem<Tier> square(size());
    const Outcome outcome = solve(square, false, [&](std::size_t a, Value& to) {
      if (!system_.load<Tier>(rows_[a], system_.variable_count(), to)) return false;
      Tier::negate(to);
      return true;
    });
    if (outcome != Outcome::kDone) return outcome;
    point.resize(system_.variable_count());
    for (std::size_t b = 0; b < size(); ++b) {
      if (Tier::sign(square.numerator(b)) != 0) {
        point[columns_[b]] = Tier::ratio(square.numerator(b), square.denominator());
      }
    }
    return Outcome::kDone;
  }

  Outcome run_optimal() {
    std::vector<Rational> point;
    const Outcome outcome = solve_point(point);
    if (outcome != Outcome::kDone) return outcome;
    std::vector<Rational> multipliers;
    if (system_.has_objective()) {
      SquareSystem<Tier> square(size());
      const Outcome dual = solve(square, true, [&](std::size_t b, Value& to) {
        return system_.load<Tier>(system_.row_count(), columns_[b], to);
      });
      if (dual != Outcome::kDone) return dual;
      multipliers.resize(system_.row_count());
      for (std::size_t a = 0; a < size(); ++a) {
        if (Tier::sign(square.numerator(a)) != 0) {
          multipliers[rows_[a]] = Tier::ratio(square.numerator(a), square.denominator());
        }
      }
    }
    result_ = make_optimal(program_, system_, std::move(point), std::move(multipliers));
    return Outcome::kDone;
  }

  /// Makes the evidence that the rows contradict each other. As witness = sum y_a s_a + ...,
  /// the combination is (its slack, or nothing for a variable) - sum y_a s_a, up to the sign
  /// that makes its constant negative.
  Outcome run_infeasible() {
    const Index n = system_.variable_count();
    const bool is_slack = proposal_.witness >= n;
    SquareSystem<Tier> square(size());
    const Outcome outcome = solve(square, true, [&](std::size_t b, Value& to) {
      if (is_slack) return system_.load<Tier>(proposal_.witness - n, columns_[b], to);
      to = columns_[b] == proposal_.witness ? 1 : 0;
      return true;
    });
    if (outcome != Outcome::kDone) return outcome;
    std::vector<Rational> multipliers(system_.row_count());
    const bool negate_slacks =
        (Tier::sign(square.denominator()) > 0) == (proposal_.direction < 0);
    for (std::size_t a = 0; a < size(); ++a) {
      Value& value = square.at(a, size());
      if (Tier::sign(value) == 0) continue;
      if (negate_slacks) Tier::negate(value);
      multipliers[rows_[a]] = Tier::to_integer(value);
    }
    if (is_slack) {
      const Integer weight = abs(Tier::to_integer(square.denominator()));
      multipliers[proposal_.witness - n] = proposal_.direction < 0 ? weight : Integer(-weight);
    }
    result_ = make_infeasible(system_, std::move(multipliers));
    return Outcome::kDone;
  }

  Outcome run_unbounded() {
    std::vector<Rational> point;
    const Outcome feasible = solve_point(point);
    if (feasible != Outcome::kDone) return feasible;
    const Index n = system_.variable_count();
    const bool is_slack = proposal_.witness >= n;
    SquareSystem<Tier> square(size());
    const Outcome outcome = solve(square, false, [&](std::size_t a, Value& to) {
      if (is_slack) {
        to = rows_[a] == proposal_.witness - n ? 1 : 0;
      } else {
        if (!system_.load<Tier>(rows_[a], proposal_.witness, to)) return false;
        Tier::negate(to);
      }
      return true;
    });
    if (outcome != Outcome::kDone) return outcome;
    const int sign = Tier::sign(square.denominator()) * proposal_.direction;
    std::vector<Rational> ray(n);
    for (std::size_t b = 0; b < size(); ++b) {
      ray[columns_[b]] = sign * Tier::to_integer(square.numerator(b));
    }
    if (!is_slack) {
      ray[proposal_.witness] = sign * Tier::to_integer(square.denominator());
    }
    result_ = make_unbounded(std::move(point), std::move(ray));
    return Outcome::kDone;
  }

  const LinearProgram& program_;
  const ScaledSystem& system_;
  const Proposal& proposal_;
  std::vector<Index> rows_;     // I
  std::vector<Index> columns_;  // J
  LpResult result_;
  typename Tier::BitMeter meter_;
};

/// Returns nothing on overflow; otherwise whether the evidence verified, and then `result` is
/// set.
template <class Tier>
std::optional<bool> confirm_in(const LinearProgram& program, const ScaledSystem& system,
                               const Proposal& proposal, LpWork& work, LpResult& result) {
  Confirmation<Tier> confirmation(program, system, proposal);
  const Outcome outcome = confirmation.run();
  work.tier = std::max(work.tier, Tier::kTier);
  work.largest_bits = std::max(work.largest_bits, confirmation.bits());
  if (outcome == Outcome::kOverflow) return std::nullopt;
  if (outcome == Outcome::kSingular) return false;
  result = confirmation.take_result();
  return verify(program, result).holds;
}

}  // namespace

std::optional<LpResult> confirm(const LinearProgram& program, const ScaledSystem& system,
                                const Proposal& proposal, LpTier first_tier, LpWork& work) {
  if (proposal.kind == Proposal::Kind::kNone) return std::nullopt;
  LpResult result;
  std::optional<bool> confirmed;
  if (first_tier == LpTier::kInt64) {
    confirmed = confirm_in<Int64Tier>(program, system, proposal, work, result);
  }
  if (!confirmed && first_tier != LpTier::kGmp) {
    confirmed = confirm_in<Int128Tier>(program, system, proposal, work, result);
  }
  if (!confirmed) confirmed = confirm_in<GmpTier>(program, system, proposal, work, result);
  if (!confirmed.value_or(false)) return std::nullopt;
  return result;
}

}  // namespace stickslip::lp_detail
