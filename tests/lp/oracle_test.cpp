// SPDX-License-Identifier: GPL-3.0-or-later
// Status and optimal value against CGAL's QP_solver.
#include <gtest/gtest.h>

#include "evidence_check.hpp"
#include "qp_oracle.hpp"
#include "random_program.hpp"

namespace stickslip::lp_test {
namespace {

void compare(unsigned seed, int count, int max_variables, int max_rows) {
  std::mt19937 random(seed);
  int seen[3] = {0, 0, 0};
  for (int k = 0; k < count; ++k) {
    const LinearProgram program = random_program(random, max_variables, max_rows);
    const LpResult result = solve(program);
    ASSERT_TRUE(check(program, result)) << "seed " << seed << ", program " << k;
    const OracleAnswer oracle = ask_qp_solver(program);
    ASSERT_EQ(status(result), oracle.status) << print(program);
    if (oracle.status == Status::kOptimal) {
      ASSERT_EQ(value(result), oracle.value) << print(program);
    }
    ++seen[static_cast<int>(oracle.status)];
  }
  // The generator is only worth its time if every answer occurs often.
  for (const int times : seen) EXPECT_GT(times, count / 20);
}

TEST(LpOracle, TinyPrograms) {
  compare(1, 3000, 3, 5);
}
TEST(LpOracle, SmallPrograms) {
  compare(2, 1500, 6, 10);
}
TEST(LpOracle, WidePrograms) {
  compare(3, 400, 16, 8);
}
TEST(LpOracle, TallPrograms) {
  compare(4, 300, 5, 30);
}

}  // namespace
}  // namespace stickslip::lp_test
