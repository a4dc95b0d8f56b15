// SPDX-License-Identifier: GPL-3.0-or-later
// The same input has the same output, to the last counter, in every thread.
#include <gtest/gtest.h>

#include <thread>

#include "evidence_check.hpp"
#include "random_program.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {
namespace {

bool same(const LpResult& a, const LpResult& b) {
  if (a.index() != b.index()) return false;
  if (const auto* x = std::get_if<Optimal>(&a)) {
    const auto& y = std::get<Optimal>(b);
    return x->point == y.point && x->value == y.value && x->dual == y.dual;
  }
  if (const auto* x = std::get_if<Infeasible>(&a))
    return x->farkas == std::get<Infeasible>(b).farkas;
  const auto& x = std::get<Unbounded>(a);
  const auto& y = std::get<Unbounded>(b);
  return x.point == y.point && x.ray == y.ray;
}

bool same(const LpWork& a, const LpWork& b) {
  return a.double_pivots == b.double_pivots && a.exact_pivots == b.exact_pivots &&
         a.basis_confirmed == b.basis_confirmed && a.tier == b.tier &&
         a.largest_bits == b.largest_bits;
}

TEST(LpProperty, SameInputSameOutputInEveryThread) {
  std::mt19937 random(23);
  std::vector<LinearProgram> programs;
  std::vector<LpResult> results;
  std::vector<LpWork> works;
  for (int k = 0; k < 200; ++k) {
    programs.push_back(random_program(random, 6, 9));
    works.emplace_back();
    results.push_back(solve(programs.back(), &works.back()));
  }
  std::vector<int> differences(3, 0);
  std::vector<std::thread> threads;
  for (int& count : differences) {
    threads.emplace_back([&] {
      for (std::size_t k = 0; k < programs.size(); ++k) {
        LpWork work;
        work.double_pivots = 12345;  // must be overwritten
        if (!same(solve(programs[k], &work), results[k])) ++count;
        if (!same(work, works[k])) ++count;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(differences, std::vector<int>(3, 0));
}

}  // namespace
}  // namespace stickslip::lp_test
