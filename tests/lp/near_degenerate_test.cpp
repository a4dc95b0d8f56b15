// SPDX-License-Identifier: GPL-3.0-or-later
// Systems that are feasible in exactly one degenerate way, or that miss it by 1e-18: double
// precision cannot tell them apart. The truth is known by construction.
#include <gtest/gtest.h>

#include <utility>

#include "evidence_check.hpp"
#include "random_program.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {
namespace {

const Rational kTiny = parse_rational("1e-18");

struct Tally {
  int fallbacks = 0;
  int confirmed = 0;
};

void expect_status(const LinearProgram& program, Status expected, Tally& tally) {
  LpWork work;
  const LpResult result = solve(program, &work);
  ASSERT_TRUE(check(program, result));
  ASSERT_EQ(status(result), expected) << print(program);
  ++(work.basis_confirmed ? tally.confirmed : tally.fallbacks);
}

/// k rows a_i.x <= a_i.x0 with sum y_i a_i = 0 for some y > 0: every solution has equality in
/// all of them. The last right-hand side is then moved by `shift`: down, and y proves
/// infeasibility; up, and it stays feasible. More rows that x0 satisfies are mixed in.
LinearProgram touching_halfspaces(std::mt19937& random, const Rational& shift) {
  const auto n = static_cast<std::size_t>(draw(random, 1, 6));
  const auto k = static_cast<std::size_t>(draw(random, 2, static_cast<int>(n) + 3));
  std::vector<Rational> x0(n);
  for (Rational& x : x0) x = Rational(draw(random, -99, 99), draw(random, 1, 9));
  std::vector<LpRow> rows(k);
  std::vector<Rational> last(n);
  for (std::size_t i = 0; i + 1 < k; ++i) {
    const Rational y(draw(random, 1, 9), draw(random, 1, 9));
    for (std::size_t j = 0; j < n; ++j) {
      rows[i].coefficients.emplace_back(draw(random, -9, 9), draw(random, 1, 9));
      last[j] -= y * rows[i].coefficients[j];
    }
  }
  rows[k - 1].coefficients = last;
  for (int extra = draw(random, 0, 5); extra > 0; --extra) {
    LpRow row;
    for (std::size_t j = 0; j < n; ++j) row.coefficients.emplace_back(draw(random, -9, 9));
    row.rhs = draw(random, 0, 3);
    rows.push_back(std::move(row));
  }
  for (LpRow& row : rows) {
    for (std::size_t j = 0; j < n; ++j) row.rhs += row.coefficients[j] * x0[j];
    row.relation = Relation::kLessEqual;
  }
  rows[k - 1].rhs += shift;
  for (LpRow& row : rows) {
    if (draw(random, 0, 1) == 0) continue;
    for (Rational& value : row.coefficients) value = -value;
    row.rhs = -row.rhs;
    row.relation = Relation::kGreaterEqual;
  }
  for (std::size_t i = rows.size() - 1; i > 0; --i) {
    std::swap(rows[i], rows[static_cast<std::size_t>(draw(random, 0, static_cast<int>(i)))]);
  }
  LinearProgram program;
  program.add_variables(n, VariableKind::kFree);
  for (LpRow& row : rows) program.add_row(row.coefficients, row.relation, row.rhs);
  return program;
}

/// Ax = b, x >= 0: all columns have y.a_j <= 0, b combines those with y.a_j = 0, so b is on
/// the border of the cone. b + shift y is outside for shift > 0.
LinearProgram touching_cone(std::mt19937& random, const Rational& shift) {
  const auto m = static_cast<std::size_t>(draw(random, 2, 5));
  const auto n = static_cast<std::size_t>(draw(random, 2, 12));
  std::vector<Rational> y(m);
  for (Rational& value : y) value = draw(random, -5, 5);
  y[0] = draw(random, 1, 5);
  std::vector<std::vector<Rational>> rows(m, std::vector<Rational>(n));
  std::vector<Rational> rhs(m);
  for (std::size_t j = 0; j < n; ++j) {
    Rational power = 0;
    for (std::size_t i = 1; i < m; ++i) {
      rows[i][j] = Rational(draw(random, -9, 9), draw(random, 1, 4));
      power += y[i] * rows[i][j];
    }
    const bool is_on_border = j == 0 || draw(random, 0, 2) == 0;
    rows[0][j] = (-power - (is_on_border ? 0 : draw(random, 1, 20))) / y[0];
    if (!is_on_border) continue;
    const Rational weight(draw(random, 0, 9), draw(random, 1, 9));
    for (std::size_t i = 0; i < m; ++i) rhs[i] += weight * rows[i][j];
  }
  LinearProgram program;
  program.add_variables(n, VariableKind::kNonNegative);
  for (std::size_t i = 0; i < m; ++i) {
    program.add_row(rows[i], Relation::kEqual, rhs[i] + shift * y[i]);
  }
  return program;
}

TEST(LpNearDegenerate, TouchingHalfspaces) {
  std::mt19937 random(18);
  Tally exact;
  Tally infeasible;
  Tally feasible;
  for (int k = 0; k < 300; ++k) {
    expect_status(touching_halfspaces(random, 0), Status::kOptimal, exact);
    expect_status(touching_halfspaces(random, -kTiny), Status::kInfeasible, infeasible);
    expect_status(touching_halfspaces(random, kTiny), Status::kOptimal, feasible);
    ASSERT_FALSE(HasFatalFailure()) << "round " << k;
  }
  // Double precision takes "infeasible by 1e-18" for feasible: this class exercises the exact
  // simplex, or it is not the class it claims to be.
  EXPECT_GT(infeasible.fallbacks, 250);
}

TEST(LpNearDegenerate, TouchingCones) {
  std::mt19937 random(81);
  Tally exact;
  Tally infeasible;
  for (int k = 0; k < 300; ++k) {
    expect_status(touching_cone(random, 0), Status::kOptimal, exact);
    expect_status(touching_cone(random, kTiny), Status::kInfeasible, infeasible);
    ASSERT_FALSE(HasFatalFailure()) << "round " << k;
  }
  EXPECT_GT(infeasible.fallbacks, 250);
}

TEST(LpNearDegenerate, OptimumMovesBy1eMinus18) {
  std::mt19937 random(7);
  for (int k = 0; k < 200; ++k) {
    // min x_0 + ... over x_j >= k_j, one bound moved by 1e-18.
    const auto n = static_cast<std::size_t>(draw(random, 1, 5));
    LinearProgram program;
    program.add_variables(n, VariableKind::kFree);
    Rational expected = 0;
    for (std::size_t j = 0; j < n; ++j) {
      std::vector<Rational> row(j + 1);
      row[j] = 1;
      const int bound = draw(random, -5, 5);
      program.add_row(row, Relation::kGreaterEqual, bound);
      program.add_row(row, Relation::kGreaterEqual, bound + kTiny * draw(random, 0, 1));
      expected += program.row(program.row_count() - 1).rhs;
    }
    program.minimize(std::vector<Rational>(n, Rational(1)));
    const LpResult result = solve(program);
    ASSERT_TRUE(check(program, result));
    ASSERT_EQ(value(result), expected);
  }
}

}  // namespace
}  // namespace stickslip::lp_test
