// SPDX-License-Identifier: GPL-3.0-or-later
// Which arithmetic answers, and when the exact simplex is needed: asserted on the counters.
#include <gtest/gtest.h>

#include <string>

#include "evidence_check.hpp"
#include "random_program.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {
namespace {

/// Infeasible (or feasible) rows with coefficients of up to `digits` digits.
LinearProgram wide_program(unsigned seed, int digits, bool make_feasible) {
  std::mt19937 random(seed);
  const std::size_t n = 3;
  const auto number = [&] {
    std::string text(static_cast<std::size_t>(digits), '0');
    for (char& c : text) c = static_cast<char>('0' + draw(random, 0, 9));
    text[0] = '7';
    const Rational value = parse_rational(text);
    return draw(random, 0, 1) == 0 ? value : Rational(-value);
  };
  LinearProgram program;
  program.add_variables(n, VariableKind::kFree);
  std::vector<Rational> sum(n);
  Rational rhs_sum = 0;
  for (int i = 0; i < 3; ++i) {
    std::vector<Rational> row(n);
    for (std::size_t j = 0; j < n; ++j) {
      row[j] = number();
      sum[j] -= row[j];
    }
    Rational rhs = number();
    rhs_sum -= rhs;
    program.add_row(std::move(row), Relation::kLessEqual, std::move(rhs));
  }
  program.add_row(sum, Relation::kLessEqual, rhs_sum + (make_feasible ? 1000000 : -1000000));
  return program;
}

struct Expected {
  int digits;
  LpTier tier;
};

// 3 x 3 minors of d digits have about 3 d digits; 64 bits hold 18, 128 bits 38.
constexpr Expected kExpected[] = {{3, LpTier::kInt64},
                                  {9, LpTier::kInt128},
                                  {17, LpTier::kGmp},
                                  {40, LpTier::kGmp},
                                  {300, LpTier::kGmp}};

TEST(LpTiers, ExactSimplexEscalates) {
  for (const Expected& expected : kExpected) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      for (const bool feasible : {true, false}) {
        const LinearProgram program = wide_program(seed, expected.digits, feasible);
        LpWork work;
        const LpResult result = solve(program, LpOptions{false, LpTier::kInt64}, &work);
        ASSERT_TRUE(check(program, result));
        EXPECT_EQ(status(result), feasible ? Status::kOptimal : Status::kInfeasible);
        EXPECT_FALSE(work.basis_confirmed);
        EXPECT_EQ(work.double_pivots, 0);
        if (feasible) continue;  // may stop before the integers grow
        EXPECT_GE(work.exact_pivots, 3);
        EXPECT_EQ(work.tier, expected.tier) << expected.digits << " digits";
        const long low[] = {1, 64, 128};
        const long high[] = {63, 127, 1L << 20};
        EXPECT_GE(work.largest_bits, low[static_cast<int>(work.tier)]);
        EXPECT_LE(work.largest_bits, high[static_cast<int>(work.tier)]);
      }
    }
  }
}

TEST(LpTiers, ConfirmationEscalates) {
  for (const Expected& expected : kExpected) {
    LinearProgram program = wide_program(3, expected.digits, true);
    program.minimize(program.row(0).coefficients);  // bounded below by the last row
    for (Rational sign : {1, -1}) {
      std::vector<Rational> objective = program.objective();
      for (Rational& value : objective) value *= sign;
      program.minimize(objective);
      LpWork work;
      const LpResult result = solve(program, &work);
      ASSERT_TRUE(check(program, result));
      ASSERT_EQ(status(result), Status::kOptimal);
      EXPECT_GE(work.tier, expected.tier) << expected.digits << " digits";
      EXPECT_GT(work.double_pivots, 0);
    }
  }
}

TEST(LpTiers, EveryFirstTierGivesTheSameAnswer) {
  std::mt19937 random(11);
  for (int k = 0; k < 1500; ++k) {
    const LinearProgram program = random_program(random, 6, 9);
    const LpResult reference = solve(program);
    for (const bool propose : {true, false}) {
      for (const LpTier tier : {LpTier::kInt64, LpTier::kInt128, LpTier::kGmp}) {
        LpWork work;
        const LpResult result = solve(program, LpOptions{propose, tier}, &work);
        ASSERT_TRUE(check(program, result));
        ASSERT_EQ(status(result), status(reference)) << print(program);
        if (status(result) == Status::kOptimal) {
          ASSERT_EQ(value(result), value(reference));
        }
        EXPECT_GE(work.tier, tier);
      }
    }
  }
}

TEST(LpTiers, SmallProgramsStayIn64BitsAndAreConfirmed) {
  LinearProgram program;
  program.add_variables(2, VariableKind::kFree);
  program.add_row({1, 1}, Relation::kGreaterEqual, 2);
  program.add_row({1, -1}, Relation::kLessEqual, 3);
  program.add_row({1, 3}, Relation::kLessEqual, 10);
  program.minimize({1, 2});
  LpWork work;
  const LpResult result = solve(program, &work);
  ASSERT_TRUE(check(program, result));
  EXPECT_EQ(value(result), Rational(3, 2));
  EXPECT_TRUE(work.basis_confirmed);
  EXPECT_EQ(work.exact_pivots, 0);
  EXPECT_EQ(work.tier, LpTier::kInt64);
  EXPECT_LE(work.largest_bits, 8);
}

TEST(LpTiers, AGapBelowDoublePrecisionFallsBack) {
  LinearProgram program;
  program.add_variable(VariableKind::kFree);
  program.add_row({1}, Relation::kLessEqual, 1);
  program.add_row({1}, Relation::kGreaterEqual, 1 + parse_rational("1e-30"));
  LpWork work;
  const LpResult result = solve(program, &work);
  ASSERT_TRUE(check(program, result));
  EXPECT_EQ(status(result), Status::kInfeasible);
  EXPECT_FALSE(work.basis_confirmed);
  EXPECT_GT(work.exact_pivots, 0);
}

TEST(LpTiers, NumbersBeyondTheRangeOfDouble) {
  const Rational huge = parse_rational("1e2000");
  const Rational tiny = 1 / huge;
  LinearProgram program;
  program.add_variables(3, VariableKind::kNonNegative);
  program.add_row({huge, tiny, 1}, Relation::kEqual, 1);
  program.add_row({tiny, -huge, 1}, Relation::kLessEqual, tiny);
  program.add_row({1, 1, 1}, Relation::kLessEqual, huge * huge);
  program.minimize({-huge, -1, -tiny});
  for (const bool propose : {true, false}) {
    LpWork work;
    const LpResult result = solve(program, LpOptions{propose, LpTier::kInt64}, &work);
    EXPECT_TRUE(check(program, result));
    EXPECT_EQ(status(result), Status::kOptimal);
    EXPECT_EQ(work.tier, LpTier::kGmp);
  }
}

TEST(LpTiers, MixedMagnitudes) {
  std::mt19937 random(99);
  const Rational scales[] = {parse_rational("1e-9"), 1, parse_rational("1e9")};
  int fallbacks = 0;
  for (int k = 0; k < 500; ++k) {
    LinearProgram program;
    const auto n = static_cast<std::size_t>(draw(random, 2, 5));
    for (std::size_t j = 0; j < n; ++j) {
      program.add_variable(draw(random, 0, 1) == 0 ? VariableKind::kFree
                                                   : VariableKind::kNonNegative);
    }
    for (int i = draw(random, 2, 8); i > 0; --i) {
      std::vector<Rational> row(n);
      for (Rational& value : row) value = draw(random, -9, 9) * scales[draw(random, 0, 2)];
      const Rational rhs = draw(random, -9, 9) * scales[draw(random, 0, 2)];
      program.add_row(row, static_cast<Relation>(draw(random, 0, 2)), rhs);
    }
    std::vector<Rational> objective(n);
    for (Rational& value : objective) value = draw(random, 0, 9) * scales[draw(random, 0, 2)];
    program.minimize(objective);
    LpWork work;
    const LpResult result = solve(program, &work);
    ASSERT_TRUE(check(program, result));
    const LpResult exact = solve(program, LpOptions{false, LpTier::kGmp});
    ASSERT_EQ(status(result), status(exact)) << print(program);
    if (status(result) == Status::kOptimal) {
      ASSERT_EQ(value(result), value(exact));
    }
    if (!work.basis_confirmed) ++fallbacks;
  }
  EXPECT_GT(fallbacks, 0);
}

// A small-entry entry of exactly -2^63 is the one 64-bit value outside the symmetric range.
TEST(LpTiers, EndsOf64Bits) {
  const Rational top = parse_rational("9223372036854775807");
  for (const Rational& bound : {top, Rational(top + 1), Rational(-top), Rational(-top - 1)}) {
    LinearProgram program;
    program.add_variable(VariableKind::kFree);
    program.add_row({3}, Relation::kGreaterEqual, bound);
    program.add_row({bound}, Relation::kLessEqual, bound * bound);
    program.minimize({1});
    const LpResult result = solve(program);
    EXPECT_TRUE(check(program, result));
    const LpResult exact = solve(program, LpOptions{false, LpTier::kInt64});
    EXPECT_TRUE(check(program, exact));
    EXPECT_EQ(status(result), status(exact));
  }
}

}  // namespace
}  // namespace stickslip::lp_test
