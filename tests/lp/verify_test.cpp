// SPDX-License-Identifier: GPL-3.0-or-later
// The public verification: right evidence passes, each kind of wrong evidence is rejected by
// the condition that names it, and on mutated evidence it agrees with the naive twin.
#include "stickslip/lp/verify.hpp"

#include <gtest/gtest.h>

#include <string>

#include "evidence_check.hpp"
#include "random_program.hpp"

namespace stickslip::lp_test {
namespace {

/// min x + y, x + 2y >= 4, x - y = 1, x <= 10, y >= 0: optimum at (2, 1), dual (2/3, 1/3, 0).
LinearProgram bounded() {
  LinearProgram program;
  program.add_variable(VariableKind::kFree);
  program.add_variable(VariableKind::kNonNegative);
  program.add_row({1, 2}, Relation::kGreaterEqual, 4);
  program.add_row({1, -1}, Relation::kEqual, 1);
  program.add_row({1}, Relation::kLessEqual, 10);
  program.minimize({1, 1});
  return program;
}

const Optimal kBoundedOptimal = {{2, 1}, 3, {Rational(2, 3), Rational(1, 3), 0}};

void expect_fails(const Verification& verification, LpCondition condition, std::size_t index) {
  EXPECT_FALSE(verification);
  EXPECT_EQ(verification.failed, condition);
  EXPECT_EQ(verification.index, index);
}

TEST(LpVerify, Optimal) {
  const LinearProgram program = bounded();
  EXPECT_TRUE(verify(program, kBoundedOptimal));
  Optimal wrong = kBoundedOptimal;
  wrong.point.pop_back();
  expect_fails(verify(program, wrong), LpCondition::kLength, 0);
  wrong = kBoundedOptimal;
  wrong.dual.emplace_back(0);
  expect_fails(verify(program, wrong), LpCondition::kLength, 0);
  wrong = kBoundedOptimal;
  wrong.point = {0, -1};
  expect_fails(verify(program, wrong), LpCondition::kPointSign, 1);
  wrong.point = {1, 0};
  expect_fails(verify(program, wrong), LpCondition::kPointRow, 0);
  wrong.point = {2, Rational(4, 3)};
  expect_fails(verify(program, wrong), LpCondition::kPointRow, 1);
  wrong.point = {11, 10};
  expect_fails(verify(program, wrong), LpCondition::kPointRow, 2);
  wrong = kBoundedOptimal;
  wrong.dual = {-1, 2, 0};
  expect_fails(verify(program, wrong), LpCondition::kMultiplierSign, 0);
  wrong.dual = {Rational(1, 3), Rational(-1, 3), 1};
  expect_fails(verify(program, wrong), LpCondition::kMultiplierSign, 2);
  wrong.dual = {Rational(2, 3), Rational(1, 4), 0};
  expect_fails(verify(program, wrong), LpCondition::kCombination, 0);
  wrong.dual = {1, 0, 0};
  expect_fails(verify(program, wrong), LpCondition::kCombination, 1);
  wrong = kBoundedOptimal;
  wrong.value = 4;
  expect_fails(verify(program, wrong), LpCondition::kPointValue, 0);
  wrong = kBoundedOptimal;  // feasible but not optimal
  wrong.point = {3, 2};
  wrong.value = 5;
  expect_fails(verify(program, wrong), LpCondition::kDualValue, 0);
}

TEST(LpVerify, Infeasible) {
  LinearProgram program;  // x + y <= 1, x >= 2, y >= 0 (a variable)
  program.add_variable(VariableKind::kFree);
  program.add_variable(VariableKind::kNonNegative);
  program.add_row({1, 1}, Relation::kLessEqual, 1);
  program.add_row({1}, Relation::kGreaterEqual, 2);
  EXPECT_TRUE(verify(program, Infeasible{{-1, 1}}));
  EXPECT_TRUE(verify(program, Infeasible{{Rational(-5, 7), Rational(5, 7)}}));
  expect_fails(verify(program, Infeasible{{-1}}), LpCondition::kLength, 0);
  expect_fails(verify(program, Infeasible{{1, 1}}), LpCondition::kMultiplierSign, 0);
  expect_fails(verify(program, Infeasible{{-1, -1}}), LpCondition::kMultiplierSign, 1);
  expect_fails(verify(program, Infeasible{{-1, 2}}), LpCondition::kCombination, 0);
  expect_fails(verify(program, Infeasible{{0, 0}}), LpCondition::kContradiction, 0);

  LinearProgram feasible;  // x <= 1, x >= 1: 0 > 0 does not follow
  feasible.add_variable(VariableKind::kFree);
  feasible.add_row({1}, Relation::kLessEqual, 1);
  feasible.add_row({1}, Relation::kGreaterEqual, 1);
  expect_fails(verify(feasible, Infeasible{{-1, 1}}), LpCondition::kContradiction, 0);

  LinearProgram nonnegative;  // y = -1 for y >= 0; the wrong sign of y combines to y <= ...
  nonnegative.add_variable(VariableKind::kNonNegative);
  nonnegative.add_row({1}, Relation::kEqual, -1);
  EXPECT_TRUE(verify(nonnegative, Infeasible{{-1}}));
  expect_fails(verify(nonnegative, Infeasible{{1}}), LpCondition::kCombination, 0);
}

TEST(LpVerify, Unbounded) {
  LinearProgram program;  // min -x, x - y <= 1, y >= 0, x + z = 0
  program.add_variable(VariableKind::kFree);
  program.add_variable(VariableKind::kNonNegative);
  program.add_variable(VariableKind::kFree);
  program.add_row({1, -1}, Relation::kLessEqual, 1);
  program.add_row({1, 0, 1}, Relation::kEqual, 0);
  program.minimize({-1});
  EXPECT_TRUE(verify(program, Unbounded{{1, 0, -1}, {1, 1, -1}}));
  expect_fails(verify(program, Unbounded{{1, 0}, {1, 1, -1}}), LpCondition::kLength, 0);
  expect_fails(verify(program, Unbounded{{1, 0, -1}, {1, 1}}), LpCondition::kLength, 0);
  expect_fails(verify(program, Unbounded{{1, -1, -1}, {1, 1, -1}}), LpCondition::kPointSign, 1);
  expect_fails(verify(program, Unbounded{{2, 0, -2}, {1, 1, -1}}), LpCondition::kPointRow, 0);
  expect_fails(verify(program, Unbounded{{1, 0, -1}, {-1, -1, 1}}), LpCondition::kRaySign, 1);
  expect_fails(verify(program, Unbounded{{1, 0, -1}, {1, 0, -1}}), LpCondition::kRayRow, 0);
  expect_fails(verify(program, Unbounded{{1, 0, -1}, {1, 1, 1}}), LpCondition::kRayRow, 1);
  expect_fails(verify(program, Unbounded{{1, 0, -1}, {-1, 0, 1}}), LpCondition::kRayDescent, 0);
  expect_fails(verify(program, Unbounded{{1, 0, -1}, {0, 0, 0}}), LpCondition::kRayDescent, 0);
}

/// Bounds on numbers that do not fit 64 bits: the GMP path of the verification.
TEST(LpVerify, SeesTheLastDigitOfLongNumbers) {
  const Rational huge = parse_rational("1e300") + Rational(1, 7);
  LinearProgram program;
  program.add_variable(VariableKind::kFree);
  program.add_row({huge}, Relation::kEqual, 1);
  EXPECT_TRUE(verify(program, Optimal{{1 / huge}, 0, {0}}));
  const Rational off = 1 / huge + parse_rational("1e-900");
  expect_fails(verify(program, Optimal{{off}, 0, {0}}), LpCondition::kPointRow, 0);
  program.add_row({1}, Relation::kGreaterEqual, off);
  EXPECT_TRUE(verify(program, Infeasible{{-1 / huge, 1}}));
  expect_fails(verify(program, Infeasible{{-1, 1}}), LpCondition::kCombination, 0);
}

/// Sums that overflow 128 bits although every number fits 64.
TEST(LpVerify, SumsBeyond128Bits) {
  const Rational top = parse_rational("9223372036854775807");
  LinearProgram program;
  program.add_variables(9, VariableKind::kFree);
  program.add_row(std::vector<Rational>(9, top), Relation::kLessEqual, 0);
  EXPECT_TRUE(verify(program, Optimal{std::vector<Rational>(9, -top), 0, {0}}));
  expect_fails(verify(program, Optimal{std::vector<Rational>(9, top), 0, {0}}),
               LpCondition::kPointRow, 0);
}

void mutate(std::mt19937& random, std::vector<Rational>& values) {
  if (values.empty()) return;
  Rational& target =
      values[static_cast<std::size_t>(draw(random, 0, static_cast<int>(values.size()) - 1))];
  switch (draw(random, 0, 3)) {
    case 0:
      target = -target;
      break;
    case 1:
      target = 0;
      break;
    case 2:
      target += parse_rational(draw(random, 0, 1) == 0 ? "1e-18" : "-1e-18");
      break;
    default:
      target += draw(random, -1, 1);
  }
}

TEST(LpVerify, AgreesWithTheNaiveTwinOnMutations) {
  std::mt19937 random(31);
  int rejected = 0;
  for (int k = 0; k < 4000; ++k) {
    const LinearProgram program = random_program(random, 5, 7);
    LpResult result = solve(program);
    ASSERT_TRUE(verify(program, result));
    if (auto* optimal = std::get_if<Optimal>(&result)) {
      mutate(random, draw(random, 0, 1) == 0 ? optimal->point : optimal->dual);
      if (draw(random, 0, 9) == 0) optimal->value += 1;
    } else if (auto* infeasible = std::get_if<Infeasible>(&result)) {
      mutate(random, infeasible->farkas);
      // The twin also wants coprime integers, which is a promise of solve, not a condition.
      bool integral = true;
      Integer divisor = 0;
      for (const Rational& y : infeasible->farkas) {
        integral = integral && denominator(y) == 1;
        divisor = gcd(divisor, numerator(y));
      }
      if (!integral || divisor != 1) continue;
    } else {
      auto& unbounded = std::get<Unbounded>(result);
      mutate(random, draw(random, 0, 1) == 0 ? unbounded.point : unbounded.ray);
    }
    const bool expected = static_cast<bool>(check(program, result));
    ASSERT_EQ(static_cast<bool>(verify(program, result)), expected) << print(program);
    if (!expected) ++rejected;
  }
  EXPECT_GT(rejected, 1000);
}

}  // namespace
}  // namespace stickslip::lp_test
