// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact simplex method: dictionaries of integers over one common denominator.
//
// A dictionary says D b_i = M_i0 + sum_j M_ij v_j for every basic b_i over the nonbasic v_j;
// D > 0 and all M_ij are minors of the scaled rows, so each pivot divides exactly (Edmonds
// 1967, Bareiss 1968).
//
// 1. Basic slacks of equations leave; they never return.
// 2. Feasibility: the basic variable >= 0 of least number among those with a negative value
//    leaves; a free nonbasic variable of nonzero coefficient enters if there is one (it never
//    leaves again), else the variable >= 0 of least number with a positive coefficient. If
//    there is none, the row proves infeasibility.
// 3. Optimality: Bland's rule for the primal simplex method.
//
// *Termination.* Steps that move an equation's slack out or a free variable in are at most
// m + n. Between them, 3 is Bland 1977, and 2 is Bland's rule for the dual simplex method
// with zero cost. Directly: suppose 2 repeats a basis, and t is the largest of the variables
// that move in the cycle. In some dictionary P, t leaves: t < 0, and the others that move are
// >= 0 or nonbasic. In another, Q, t enters in the row of some r: its constant is negative,
// t's coefficient positive, those of the others that move <= 0. Put P's basic solution in
// that row, r - sum a_j v_j = constant < 0: variables that do not move are nonbasic in P
// (being nonbasic in Q) and so 0; every remaining term on the left is >= 0. Contradiction.
#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "integer_tier.hpp"
#include "steps.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::lp_detail {
namespace {

constexpr Index kNone = static_cast<Index>(-1);

template <class Tier>
class Dictionary {
 public:
  using Value = typename Tier::Value;

  explicit Dictionary(const ScaledSystem& system)
      : rows_(system.row_count() + (system.has_objective() ? 1U : 0U)),
        columns_(system.variable_count() + 1),
        cells_(std::size_t{rows_} * columns_),
        next_(cells_.size()),
        denominator_(1),
        basic_(system.row_count()),
        nonbasic_(system.variable_count()) {
    std::iota(nonbasic_.begin(), nonbasic_.end(), Index{0});
    std::iota(basic_.begin(), basic_.end(), system.variable_count());
  }

  /// Fills in the scaled rows. Returns false if they do not fit this tier.
  bool load(const ScaledSystem& system) {
    for (Index i = 0; i < rows_; ++i) {
      for (Index j = 0; j < columns_; ++j) {
        Value& to = cells_[std::size_t{i} * columns_ + j];
        if (!system.load<Tier>(i, j, to)) return false;
        meter_.note(to);
      }
    }
    return true;
  }

  /// Makes the same dictionary in larger integers.
  template <class Smaller>
  explicit Dictionary(const Dictionary<Smaller>& from)
      : rows_(from.rows_),
        columns_(from.columns_),
        cells_(from.cells_.size()),
        next_(from.cells_.size()),
        basic_(from.basic_),
        nonbasic_(from.nonbasic_) {
    const auto widen = [](const typename Smaller::Value& value, Value& to) {
      require(Tier::load(Smaller::to_integer(value), to), "lp: a larger tier is too small");
    };
    widen(from.denominator_, denominator_);
    for (std::size_t k = 0; k < cells_.size(); ++k) widen(from.cells_[k], cells_[k]);
  }

  Index row_count() const { return static_cast<Index>(basic_.size()); }
  Index column_count() const { return static_cast<Index>(nonbasic_.size()); }
  Index basic(Index row) const { return basic_[row]; }
  Index nonbasic(Index column) const { return nonbasic_[column]; }
  const Value& denominator() const { return denominator_; }
  const Value& at(Index row, Index column) const {
    return cells_[std::size_t{row} * columns_ + column];
  }
  const Value& constant(Index row) const { return at(row, column_count()); }
  /// The cost of a column, in the row after the basic ones.
  const Value& cost(Index column) const { return at(row_count(), column); }
  int sign(Index row, Index column) const { return Tier::sign(at(row, column)); }
  int constant_sign(Index row) const { return Tier::sign(constant(row)); }
  long bits() const { return meter_.bits(); }

  /// Exchanges basic(row) and nonbasic(column). On overflow returns false and leaves the
  /// dictionary as it was. Requires a nonzero coefficient there.
  bool pivot(Index row, Index column) {
    const typename Tier::Divisor divisor(denominator_);
    Value pivot = at(row, column);
    const bool negative = Tier::sign(pivot) < 0;
    if (negative) Tier::negate(pivot);
    const Value* const pivot_row = &at(row, 0);
    Value factor;
    for (Index i = 0; i < rows_; ++i) {
      if (i == row) continue;
      const Value* const from = &at(i, 0);
      Value* const to = &next_[std::size_t{i} * columns_];
      factor = from[column];
      if (negative) Tier::negate(factor);
      for (Index j = 0; j < columns_; ++j) {
        if (j == column) continue;
        if (!Tier::fused(from[j], pivot, factor, pivot_row[j], divisor, to[j])) return false;
        meter_.note(to[j]);
      }
      to[column] = factor;
    }
    Value* const to = &next_[std::size_t{row} * columns_];
    for (Index j = 0; j < columns_; ++j) {
      to[j] = j == column ? denominator_ : pivot_row[j];
      if (negative == (j == column)) Tier::negate(to[j]);
    }
    cells_.swap(next_);
    denominator_ = std::move(pivot);
    std::swap(basic_[row], nonbasic_[column]);
    return true;
  }

 private:
  template <class>
  friend class Dictionary;

  Index rows_;
  Index columns_;
  std::vector<Value> cells_;  // row by row, the constant last in each
  std::vector<Value> next_;   // a pivot writes here, then swaps: no allocation per pivot
  Value denominator_{};
  std::vector<Index> basic_;
  std::vector<Index> nonbasic_;
  typename Tier::BitMeter meter_;
};

/// One run of the method in one tier.
template <class Tier>
class Run {
 public:
  using Value = typename Tier::Value;

  /// Takes the nonbasic set `start` to begin with, and empties it once it has been reached.
  Run(const LinearProgram& program, const ScaledSystem& system, std::vector<Index>& start,
      Dictionary<Tier>& dictionary, LpWork& work)
      : program_(program), system_(system), start_(start), d_(dictionary), work_(work) {}

  /// Returns nothing when an integer outgrew the tier. The dictionary is then valid, and the
  /// method can continue from it in the next tier.
  std::optional<LpResult> solve() {
    if (!go_to_start() || !remove_equations()) return std::nullopt;
    if (!result_ && !reach_feasibility()) return std::nullopt;
    if (!result_ && !reach_optimality()) return std::nullopt;
    return std::move(result_);
  }

 private:
  // Each phase returns false on overflow and can be entered again after it.

  bool pivot(Index row, Index column) {
    if (!d_.pivot(row, column)) return false;
    ++work_.exact_pivots;
    return true;
  }

  Domain basic_domain(Index row) const { return system_.domain(d_.basic(row)); }
  Domain nonbasic_domain(Index column) const { return system_.domain(d_.nonbasic(column)); }

  /// Makes the start's nonbasic set nonbasic, as far as it is a basis at all, by Gaussian
  /// elimination: at most min(m, n) pivots.
  bool go_to_start() {
    if (start_.empty()) return true;
    std::vector<bool> wanted(std::size_t{system_.variable_count()} + system_.row_count());
    for (const Index variable : start_) wanted[variable] = true;
    for (Index j = 0; j < d_.column_count(); ++j) {
      if (wanted[d_.nonbasic(j)]) continue;
      for (Index i = 0; i < d_.row_count(); ++i) {
        if (!wanted[d_.basic(i)] || d_.sign(i, j) == 0) continue;
        if (!pivot(i, j)) return false;
        break;
      }
    }
    start_.clear();
    return true;
  }

  bool remove_equations() {
    for (Index i = 0; i < d_.row_count() && !result_; ++i) {
      if (basic_domain(i) != Domain::kZero) continue;
      Index entering = kNone;
      for (Index j = 0; j < d_.column_count(); ++j) {
        if (nonbasic_domain(j) == Domain::kZero || d_.sign(i, j) == 0) continue;
        if (entering == kNone || nonbasic_domain(j) == Domain::kFree) entering = j;
        if (nonbasic_domain(entering) == Domain::kFree) break;
      }
      if (entering != kNone) {
        if (!pivot(i, entering)) return false;
      } else if (d_.constant_sign(i) != 0) {
        report_infeasible(i);
      }
    }
    return true;
  }

  bool reach_feasibility() {
    for (;;) {
      throw_if_cancelled();
      Index leaving = kNone;
      for (Index i = 0; i < d_.row_count(); ++i) {
        if (basic_domain(i) == Domain::kNonNegative && d_.constant_sign(i) < 0 &&
            (leaving == kNone || d_.basic(i) < d_.basic(leaving))) {
          leaving = i;
        }
      }
      if (leaving == kNone) return true;
      Index entering = kNone;
      for (Index j = 0; j < d_.column_count(); ++j) {
        const Domain domain = nonbasic_domain(j);
        const int sign = d_.sign(leaving, j);
        if (domain == Domain::kFree && sign != 0) {
          entering = j;
          break;
        }
        if (domain == Domain::kNonNegative && sign > 0 &&
            (entering == kNone || d_.nonbasic(j) < d_.nonbasic(entering))) {
          entering = j;
        }
      }
      if (entering == kNone) {
        report_infeasible(leaving);
        return true;
      }
      if (!pivot(leaving, entering)) return false;
    }
  }

  bool reach_optimality() {
    while (system_.has_objective()) {
      throw_if_cancelled();
      Index entering = kNone;
      for (Index j = 0; j < d_.column_count(); ++j) {
        const Domain domain = nonbasic_domain(j);
        const int sign = Tier::sign(d_.cost(j));
        const bool improves = (domain == Domain::kFree && sign != 0) ||
                              (domain == Domain::kNonNegative && sign < 0);
        if (improves && (entering == kNone || d_.nonbasic(j) < d_.nonbasic(entering))) {
          entering = j;
        }
      }
      if (entering == kNone) break;
      const int direction = -Tier::sign(d_.cost(entering));
      const Index leaving = blocking_row(entering, direction);
      if (leaving == kNone) {
        report_unbounded(entering, direction);
        return true;
      }
      if (!pivot(leaving, entering)) return false;
    }
    report_optimal();
    return true;
  }

  /// Returns the row of least ratio, of least number among equals.
  Index blocking_row(Index entering, int direction) const {
    Index best = kNone;
    for (Index i = 0; i < d_.row_count(); ++i) {
      if (basic_domain(i) != Domain::kNonNegative) continue;
      if (d_.sign(i, entering) * direction >= 0) continue;
      if (best == kNone) {
        best = i;
        continue;
      }
      // constant_i / |a_i| against constant_best / |a_best|, both a of sign -direction.
      const int order =
          -direction * Tier::compare_products(d_.constant(i), d_.at(best, entering),
                                              d_.constant(best), d_.at(i, entering));
      if (order < 0 || (order == 0 && d_.basic(i) < d_.basic(best))) best = i;
    }
    return best;
  }

  std::vector<Rational> point() const {
    std::vector<Rational> out(system_.variable_count());
    for (Index i = 0; i < d_.row_count(); ++i) {
      if (d_.basic(i) < system_.variable_count() && d_.constant_sign(i) != 0) {
        out[d_.basic(i)] = Tier::ratio(d_.constant(i), d_.denominator());
      }
    }
    return out;
  }

  void report_infeasible(Index row) {
    const Index n = system_.variable_count();
    std::vector<Rational> multipliers(system_.row_count());
    if (d_.basic(row) >= n) multipliers[d_.basic(row) - n] = Tier::to_integer(d_.denominator());
    for (Index j = 0; j < d_.column_count(); ++j) {
      if (d_.nonbasic(j) < n) continue;
      multipliers[d_.nonbasic(j) - n] = -Tier::to_integer(d_.at(row, j));
    }
    if (d_.constant_sign(row) > 0) {  // an equation; the combination must be negative
      for (Rational& multiplier : multipliers) multiplier = -multiplier;
    }
    result_ = make_infeasible(system_, std::move(multipliers));
  }

  void report_unbounded(Index column, int direction) {
    const Index n = system_.variable_count();
    std::vector<Rational> ray(n);
    if (d_.nonbasic(column) < n) {
      ray[d_.nonbasic(column)] = direction * Tier::to_integer(d_.denominator());
    }
    for (Index i = 0; i < d_.row_count(); ++i) {
      if (d_.basic(i) < n) ray[d_.basic(i)] = direction * Tier::to_integer(d_.at(i, column));
    }
    result_ = make_unbounded(point(), std::move(ray));
  }

  void report_optimal() {
    const Index n = system_.variable_count();
    std::vector<Rational> multipliers;
    if (system_.has_objective()) {
      multipliers.resize(system_.row_count());
      for (Index j = 0; j < d_.column_count(); ++j) {
        if (d_.nonbasic(j) < n) continue;
        multipliers[d_.nonbasic(j) - n] = Tier::ratio(d_.cost(j), d_.denominator());
      }
    }
    result_ = make_optimal(program_, system_, point(), std::move(multipliers));
  }

  const LinearProgram& program_;
  const ScaledSystem& system_;
  std::vector<Index>& start_;
  Dictionary<Tier>& d_;
  LpWork& work_;
  std::optional<LpResult> result_;
};

/// Runs in this tier, and on overflow continues in the next. Requires that `dictionary` is
/// loaded.
template <class Tier>
LpResult run_from(const LinearProgram& program, const ScaledSystem& system,
                  std::vector<Index>& start, Dictionary<Tier>& dictionary, LpWork& work) {
  std::optional<LpResult> result = Run<Tier>(program, system, start, dictionary, work).solve();
  work.tier = std::max(work.tier, Tier::kTier);
  work.largest_bits = std::max(work.largest_bits, dictionary.bits());
  if (result) return *std::move(result);
  if constexpr (std::is_same_v<Tier, Int64Tier>) {
    Dictionary<Int128Tier> larger(dictionary);
    return run_from<Int128Tier>(program, system, start, larger, work);
  } else if constexpr (std::is_same_v<Tier, Int128Tier>) {
    Dictionary<GmpTier> larger(dictionary);
    return run_from<GmpTier>(program, system, start, larger, work);
  } else {
    throw ContractError("lp: GMP integers overflowed");
  }
}

template <class Tier>
std::optional<LpResult> try_tier(const LinearProgram& program, const ScaledSystem& system,
                                 std::vector<Index>& start, LpWork& work) {
  Dictionary<Tier> dictionary(system);
  if (!dictionary.load(system)) return std::nullopt;
  return run_from<Tier>(program, system, start, dictionary, work);
}

}  // namespace

LpResult solve_exactly(const LinearProgram& program, const ScaledSystem& system,
                       std::vector<Index> start, LpTier first_tier, LpWork& work) {
  std::optional<LpResult> result;
  if (first_tier == LpTier::kInt64) result = try_tier<Int64Tier>(program, system, start, work);
  if (!result && first_tier != LpTier::kGmp) {
    result = try_tier<Int128Tier>(program, system, start, work);
  }
  if (!result) result = try_tier<GmpTier>(program, system, start, work);
  require(result.has_value(), "lp: a program does not fit GMP integers");
  return *std::move(result);
}

}  // namespace stickslip::lp_detail
