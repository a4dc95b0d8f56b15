// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A linear program as the solvers see it: integer rows, one slack per row; and the way back,
/// from what they find about these rows to the evidence about the rows as given.
///
/// Row i, a.x (<=,=,>=) b, becomes s_i = g_i.x + h_i with (g_i, h_i) = f_i (a, -b), coprime
/// integers; f_i > 0 for rows >= and =, f_i < 0 for rows <=. So the program says: slacks of
/// inequalities are >= 0, slacks of equations are = 0.
#pragma once

#include <cstdint>
#include <vector>

#include "stickslip/core/number.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_detail {

/// The number of a variable of the simplex method: x_0..x_{n-1} come first, then s_0..s_{m-1}.
using Index = std::uint32_t;

/// The values that a variable may have: any number, >= 0, or 0 only (the slack of an equation).
enum class Domain : std::uint8_t { kFree, kNonNegative, kZero };

class ScaledSystem {
 public:
  explicit ScaledSystem(const LinearProgram& program);

  Index variable_count() const { return n_; }
  Index row_count() const { return m_; }
  bool has_objective() const { return has_objective_; }
  Domain domain(Index variable) const { return domains_[variable]; }

  /// Gives access to the scaled integers. Rows 0..m-1 are (g_i, h_i). Row m, if
  /// has_objective(), is the objective scaled to coprime integers by a positive factor, and 0.
  /// Column n holds the h_i. Entries are in small() if is_small(), else in big().
  bool is_small() const { return big_.empty(); }
  std::int64_t small(Index row, Index column) const {
    return small_[std::size_t{row} * (std::size_t{n_} + 1) + column];
  }
  const Integer& big(Index row, Index column) const {
    return big_[std::size_t{row} * (std::size_t{n_} + 1) + column];
  }
  template <class Tier>
  bool load(Index row, Index column, typename Tier::Value& to) const {
    return is_small() ? Tier::load(small(row, column), to) : Tier::load(big(row, column), to);
  }

  /// Returns the factor f_i of a row, or that of the objective for row m. It is 1 for a row of
  /// zeros.
  Rational factor(Index row) const;

  /// Writes a row divided by its largest coefficient, approximately, with the constant first.
  /// It serves proposals.
  void approximate_row(Index row, double* constant_then_coefficients) const;

 private:
  void add_big_row(const std::vector<Rational>& coefficients, const Rational* rhs, bool flip);

  const LinearProgram& program_;
  Index n_;
  Index m_;
  bool has_objective_ = false;
  std::vector<Domain> domains_;
  std::vector<std::int64_t> small_;
  std::vector<Integer> big_;  // used for all rows as soon as one entry exceeds 64 bits
};

// These functions turn integers about the scaled rows into evidence about the rows as given.

/// Returns the evidence of an optimum. `multipliers` (one per row, or none for 0) say that the
/// scaled objective is sum multipliers_i (g_i.x + h_i) + terms in variables >= 0 + constant.
Optimal make_optimal(const LinearProgram& program, const ScaledSystem& system,
                     std::vector<Rational> point, std::vector<Rational> multipliers);

/// Returns the evidence of a contradiction: sum multipliers_i (g_i.x + h_i) = (terms that are
/// <= 0) + a negative constant.
Infeasible make_infeasible(const ScaledSystem& system, std::vector<Rational> multipliers);

Unbounded make_unbounded(std::vector<Rational> point, std::vector<Rational> ray);

}  // namespace stickslip::lp_detail
