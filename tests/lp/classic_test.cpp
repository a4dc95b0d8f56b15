// SPDX-License-Identifier: GPL-3.0-or-later
// Programs from the literature with known optima: those on which the simplex method with
// Dantzig's rule cycles, and those on which it takes 2^n - 1 steps.
#include <gtest/gtest.h>

#include "evidence_check.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {
namespace {

void expect_optimum(const LinearProgram& program, const Rational& expected) {
  for (const bool propose : {true, false}) {
    const LpResult result = solve(program, LpOptions{propose, LpTier::kInt64});
    ASSERT_TRUE(check(program, result));
    ASSERT_EQ(status(result), Status::kOptimal);
    EXPECT_EQ(value(result), expected);
  }
}

// E. M. L. Beale, Cycling in the dual simplex algorithm, 1955.
TEST(LpClassic, Beale) {
  LinearProgram program;
  program.add_variables(4, VariableKind::kNonNegative);
  program.add_row({Rational(1, 4), -60, Rational(-1, 25), 9}, Relation::kLessEqual, 0);
  program.add_row({Rational(1, 2), -90, Rational(-1, 50), 3}, Relation::kLessEqual, 0);
  program.add_row({0, 0, 1}, Relation::kLessEqual, 1);
  program.minimize({Rational(-3, 4), 150, Rational(-1, 50), 6});
  expect_optimum(program, Rational(-1, 20));
}

// V. Chvatal, Linear Programming, 1983, chapter 3 (after Marshall and Suurballe 1969).
TEST(LpClassic, MarshallSuurballe) {
  LinearProgram program;
  program.add_variables(4, VariableKind::kNonNegative);
  program.add_row({Rational(1, 2), Rational(-11, 2), Rational(-5, 2), 9}, Relation::kLessEqual,
                  0);
  program.add_row({Rational(1, 2), Rational(-3, 2), Rational(-1, 2), 1}, Relation::kLessEqual,
                  0);
  program.add_row({1}, Relation::kLessEqual, 1);
  program.minimize({-10, 57, 9, 24});
  expect_optimum(program, -1);
}

// H. W. Kuhn, in M. L. Balinski, A. W. Tucker, SIAM Review 11, 1969.
TEST(LpClassic, Kuhn) {
  LinearProgram program;
  program.add_variables(4, VariableKind::kNonNegative);
  program.add_row({-2, -9, 1, 9}, Relation::kLessEqual, 0);
  program.add_row({Rational(1, 3), 1, Rational(-1, 3), -2}, Relation::kLessEqual, 0);
  program.minimize({-2, -3, 1, 12});
  for (const bool propose : {true, false}) {
    const LpResult result = solve(program, LpOptions{propose, LpTier::kInt64});
    EXPECT_TRUE(check(program, result));
    EXPECT_EQ(status(result), Status::kUnbounded);
  }
  program.add_row({2, 3, -1, -12}, Relation::kLessEqual, 2);
  expect_optimum(program, -2);
}

// Ten columns at one degenerate vertex, turned by multiples of 72 degrees as in A. J. Hoffman's
// cycling example (1953). Its cosines are irrational; rounded to 30 digits, each full turn
// returns to the same numbers in double precision, but not exactly.
TEST(LpClassic, TurnedColumns) {
  const Rational c1 = parse_rational("0.309016994374947424102293417183");
  const Rational c2 = parse_rational("-0.809016994374947424102293417183");
  const Rational s1 = parse_rational("0.951056516295153572116439333379");
  const Rational s2 = parse_rational("0.587785252292473129168705954639");
  for (int cost = -3; cost <= 3; ++cost) {
    LinearProgram program;
    program.add_variables(10, VariableKind::kNonNegative);
    program.add_row({c1, s1, c2, s2, c2, -s2, c1, -s1, 1, 0}, Relation::kEqual, 0);
    program.add_row({-s1, c1, -s2, c2, s2, c2, s1, c1, 0, 1}, Relation::kEqual, 0);
    program.minimize({cost, 2, cost, 3, cost, 2, cost, 3, 4, 4});
    const LpResult reference = solve(program, LpOptions{false, LpTier::kGmp});
    EXPECT_TRUE(check(program, reference));
    const LpResult result = solve(program);
    EXPECT_TRUE(check(program, result));
    EXPECT_EQ(status(result), status(reference));
    if (status(result) == Status::kOptimal) {
      EXPECT_EQ(value(result), 0);  // of a cone
    }
  }
}

// V. Klee, G. J. Minty 1972, in Chvatal's form: max sum 10^(n-j) x_j subject to
// 2 sum_{j<i} 10^(i-j) x_j + x_i <= 100^(i-1); the optimum is 100^(n-1).
TEST(LpClassic, KleeMinty) {
  for (std::size_t n = 1; n <= 10; ++n) {
    const auto power_of_10 = [](std::size_t exponent) {
      return Rational(pow(Integer(10), static_cast<unsigned>(exponent)));
    };
    LinearProgram program;
    program.add_variables(n, VariableKind::kNonNegative);
    std::vector<Rational> objective(n);
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<Rational> row(i + 1);
      for (std::size_t j = 0; j < i; ++j) row[j] = 2 * power_of_10(i - j);
      row[i] = 1;
      program.add_row(row, Relation::kLessEqual, power_of_10(2 * i));
      objective[i] = -power_of_10(n - 1 - i);
    }
    program.minimize(objective);
    expect_optimum(program, -power_of_10(2 * (n - 1)));
    LpWork work;
    solve(program, &work);
    EXPECT_LE(work.double_pivots + work.exact_pivots, 1L << 11);
  }
}

}  // namespace
}  // namespace stickslip::lp_test
