// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact linear programming over the rationals, for small dense systems.
///
///     minimize  c.x   subject to   a_i.x  (<=, =, >=)  b_i   (i = 1..m),
///               each x_j free or >= 0   (j = 1..n).
///
/// Every answer carries evidence that anyone can check by substitution, in the sign
/// convention below; `verify` (verify.hpp) is that check, and `solve` never returns
/// evidence that it has not passed, in any build type.
///
/// **Multipliers.** A vector y with one entry per row is *admissible* when
///
///     y_i >= 0 for a row >=,   y_i <= 0 for a row <=,   y_i of any sign for a row =.
///
/// Then y_i (a_i.x) >= y_i b_i for every x that satisfies row i, and by summation
///
///     (yA).x >= y.b   for every x that satisfies the rows.                        (1)
///
/// - Optimal: x feasible, y = `dual` admissible, with reduced cost r = c - yA
///   satisfying r_j = 0 for free x_j and r_j >= 0 for x_j >= 0, and c.x = y.b = value.
///   No feasible x' is better: c.x' = (yA).x' + r.x' >= (yA).x' >= y.b by (1).
/// - Infeasible: y = `farkas` admissible, (yA)_j = 0 for free x_j and (yA)_j <= 0 for
///   x_j >= 0, and y.b > 0. A feasible x' would give 0 >= (yA).x' >= y.b > 0 by (1).
/// - Unbounded: `point` feasible; `ray` d with a_i.d >= 0, = 0, <= 0 for a row >=, =, <=,
///   d_j >= 0 for x_j >= 0, and c.d < 0. Then point + t d is feasible for all t >= 0 and
///   its cost falls without end.
///
/// **Method.** A dictionary simplex in double precision proposes a basis; the basis is
/// solved exactly and its evidence verified exactly (Dhiflaoui et al., "Certifying and
/// repairing solutions to large LPs", SODA 2003; Applegate, Cook, Dash, Espinoza, "Exact
/// solutions to linear programming problems", Oper. Res. Lett. 35, 2007). When it is not
/// confirmed, an exact simplex continues from it: integer pivoting with one common
/// denominator (Edmonds 1967; Bareiss 1968) in 64-bit, then 128-bit, then GMP integers,
/// each overflow detected exactly, with Bland's rule (Bland 1977), hence finite. No tolerance
/// decides an answer: tolerances only choose what to propose.
///
/// **Cost.** A pivot costs O(mn) operations. A confirmed answer costs one double simplex, one
/// fraction-free solve of a k x k system, k <= min(m, n), in O(k^3) integer operations, and
/// O(mn) integer operations of verification. The number of pivots is a small multiple of
/// m + n in practice and exponential in the worst case. Integers met are minors of the rows
/// scaled to coprime integers, so Hadamard's inequality bounds their length.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "stickslip/core/number.hpp"

namespace stickslip {

/// The kinds of variable: x_j of any sign, or x_j >= 0.
enum class VariableKind { kFree, kNonNegative };
/// The relation between the two sides of a row: <=, = or >=.
enum class Relation { kLessEqual, kEqual, kGreaterEqual };

/// A row: coefficients.x relation rhs. Coefficients that are not given are 0.
struct LpRow {
  std::vector<Rational> coefficients;    ///< a_i, by variable
  Relation relation = Relation::kEqual;  ///< the relation between a_i.x and b_i
  Rational rhs;                          ///< b_i
};

/// A linear program: min objective.x subject to rows coefficients.x (<=,=,>=) rhs, each
/// variable free or >= 0.
class LinearProgram {
 public:
  /// Adds a variable and returns its index.
  std::size_t add_variable(VariableKind kind);
  /// Adds `count` variables and returns the index of the first.
  std::size_t add_variables(std::size_t count, VariableKind kind);
  /// Adds a row and returns its index. `coefficients` may be shorter than the number of
  /// variables: the rest are 0. Throws ContractError if it is longer.
  std::size_t add_row(std::vector<Rational> coefficients, Relation relation, Rational rhs);
  /// Sets the objective, which may be shorter as in add_row. Without it, the objective is zero
  /// and the program asks for a feasible point.
  void minimize(std::vector<Rational> objective);

  std::size_t variable_count() const { return kinds_.size(); }  ///< n, the number of variables
  std::size_t row_count() const { return rows_.size(); }        ///< m, the number of rows
  /// Returns the kind of a variable. Requires variable < variable_count().
  VariableKind kind(std::size_t variable) const { return kinds_[variable]; }
  /// Returns a row. Requires index < row_count().
  const LpRow& row(std::size_t index) const { return rows_[index]; }
  /// Returns the objective. It may be shorter than the number of variables: the rest are 0.
  const std::vector<Rational>& objective() const { return objective_; }

 private:
  std::vector<VariableKind> kinds_;
  std::vector<LpRow> rows_;
  std::vector<Rational> objective_;
};

/// An optimal point, and a dual that proves it optimal. If the objective is zero, it is a
/// feasible point with value 0 and dual 0.
struct Optimal {
  std::vector<Rational> point;  ///< one per variable
  Rational value;               ///< c.x, the least there is
  std::vector<Rational> dual;   ///< one per row
};

/// A proof that the rows contradict each other: `farkas` combines them to 0 > 0. Coprime
/// integers.
struct Infeasible {
  std::vector<Rational> farkas;  ///< one per row
};

/// A feasible point, and a direction of feasible descent without end (coprime integers).
struct Unbounded {
  std::vector<Rational> point;  ///< one per variable
  std::vector<Rational> ray;    ///< one per variable
};

/// One of the three outcomes that a linear program has, with its evidence.
using LpResult = std::variant<Optimal, Infeasible, Unbounded>;

/// The integers that exact arithmetic used.
enum class LpTier { kInt64, kInt128, kGmp };

/// The work of one call of `solve`. Reproducible: the same program gives the same counts.
struct LpWork {
  long double_pivots = 0;  ///< pivots of the simplex in double precision
  long exact_pivots = 0;   ///< pivots of the exact simplex; 0 when the basis was confirmed
  bool basis_confirmed = false;  ///< whether the basis proposed in double proved to be final
  LpTier tier = LpTier::kInt64;  ///< the largest integers that were needed
  long largest_bits = 0;         ///< bit length of the longest integer of exact elimination
};

/// Ways to solve, all of which give a right answer. They serve tests, benchmarks and
/// comparison.
struct LpOptions {
  bool propose = true;                 ///< false: exact simplex from the start
  LpTier first_tier = LpTier::kInt64;  ///< exact arithmetic starts here
};

/// \{ \brief Returns the outcome of the program with evidence that has been verified exactly.
/// Thread-safe, deterministic, no globals. Throws ContractError if the evidence fails its own
/// verification (a defect of this library, never of the input). `work`, if given, is
/// overwritten.
LpResult solve(const LinearProgram& program, LpWork* work = nullptr);
LpResult solve(const LinearProgram& program, const LpOptions& options, LpWork* work = nullptr);
/// \}

}  // namespace stickslip
