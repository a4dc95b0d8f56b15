// SPDX-License-Identifier: GPL-3.0-or-later
// The ends of the range: no variables, no rows, nothing in a row.
#include <gtest/gtest.h>

#include "evidence_check.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {
namespace {

/// Solves in all ways; they must agree, and prove it.
LpResult solve_checked(const LinearProgram& program) {
  LpResult result = solve(program);
  EXPECT_TRUE(check(program, result));
  for (const LpTier tier : {LpTier::kInt64, LpTier::kInt128, LpTier::kGmp}) {
    const LpResult exact = solve(program, LpOptions{false, tier});
    EXPECT_TRUE(check(program, exact));
    EXPECT_EQ(status(exact), status(result)) << print(program);
  }
  return result;
}

TEST(LpEdge, NothingAtAll) {
  const LinearProgram program;
  const LpResult result = solve_checked(program);
  ASSERT_EQ(status(result), Status::kOptimal);
  EXPECT_EQ(value(result), 0);
}

TEST(LpEdge, NoRows) {
  for (const VariableKind kind : {VariableKind::kFree, VariableKind::kNonNegative}) {
    for (const int cost : {-1, 0, 1}) {
      LinearProgram program;
      program.add_variable(kind);
      program.minimize({cost});
      const bool bounded = cost == 0 || (cost > 0 && kind == VariableKind::kNonNegative);
      EXPECT_EQ(status(solve_checked(program)),
                bounded ? Status::kOptimal : Status::kUnbounded);
    }
  }
}

TEST(LpEdge, RedundantEquations) {
  LinearProgram program;
  program.add_variables(3, VariableKind::kNonNegative);
  program.add_row({1, 1, 1}, Relation::kEqual, 6);
  program.add_row({2, 2, 2}, Relation::kEqual, 12);
  program.add_row({1, -1, 0}, Relation::kEqual, 1);
  program.add_row({3, 1, 2}, Relation::kEqual, 13);
  program.minimize({-1, -1, 0});
  const LpResult result = solve_checked(program);
  ASSERT_EQ(status(result), Status::kOptimal);
  EXPECT_EQ(value(result), -6);

  program.add_row({3, 1, 2}, Relation::kEqual, Rational(13 * 7 + 1, 7));
  EXPECT_EQ(status(solve_checked(program)), Status::kInfeasible);
}

TEST(LpEdge, ShortRowsMeanZeros) {
  LinearProgram program;
  program.add_variable(VariableKind::kFree);
  program.add_row({1}, Relation::kGreaterEqual, 2);
  program.add_variable(VariableKind::kFree);
  program.add_row({1, 1}, Relation::kLessEqual, 0);
  program.minimize({1});
  const LpResult result = solve_checked(program);
  ASSERT_EQ(status(result), Status::kOptimal);
  EXPECT_EQ(value(result), 2);
}

TEST(LpEdge, LongRowsBreakTheContract) {
  LinearProgram program;
  program.add_variable(VariableKind::kFree);
  EXPECT_THROW(program.add_row({1, 2}, Relation::kEqual, 0), ContractError);
  EXPECT_THROW(program.minimize({1, 2}), ContractError);
  EXPECT_EQ(program.row_count(), 0U);
}

}  // namespace
}  // namespace stickslip::lp_test
