// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change an answer, and what must not change anything at all.
#include <gtest/gtest.h>

#include <numeric>
#include <thread>

#include "evidence_check.hpp"
#include "random_program.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {
namespace {

std::vector<std::size_t> permutation(std::mt19937& random, std::size_t size) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = size; i > 1; --i) {
    std::swap(order[i - 1],
              order[static_cast<std::size_t>(draw(random, 0, static_cast<int>(i) - 1))]);
  }
  return order;
}

Rational at(const std::vector<Rational>& values, std::size_t j) {
  return j < values.size() ? values[j] : Rational(0);
}

/// Variables and rows in another order; rows times positive numbers or turned around;
/// variable j measured in other units (times units[j] > 0).
LinearProgram transformed(std::mt19937& random, const LinearProgram& program) {
  const std::size_t n = program.variable_count();
  const std::vector<std::size_t> columns = permutation(random, n);
  const auto positive = [&] { return Rational(draw(random, 1, 1000), draw(random, 1, 1000)); };
  std::vector<Rational> units(n);
  for (Rational& unit : units) unit = positive();
  LinearProgram out;
  for (const std::size_t j : columns) out.add_variable(program.kind(j));
  const auto moved = [&](const std::vector<Rational>& values, const Rational& factor) {
    std::vector<Rational> to(n);
    for (std::size_t k = 0; k < n; ++k) to[k] = at(values, columns[k]) * units[k] * factor;
    return to;
  };
  for (const std::size_t i : permutation(random, program.row_count())) {
    const LpRow& row = program.row(i);
    Rational factor = positive();
    Relation relation = row.relation;
    if (draw(random, 0, 1) == 0) {
      factor = -factor;
      relation = relation == Relation::kLessEqual      ? Relation::kGreaterEqual
                 : relation == Relation::kGreaterEqual ? Relation::kLessEqual
                                                       : relation;
    }
    out.add_row(moved(row.coefficients, factor), relation, row.rhs * factor);
  }
  out.minimize(moved(program.objective(), 1));
  return out;
}

TEST(LpProperty, OrderAndUnitsDoNotMatter) {
  std::mt19937 random(21);
  for (int k = 0; k < 2000; ++k) {
    const LinearProgram program = random_program(random, 6, 9);
    const LinearProgram other = transformed(random, program);
    const LpResult a = solve(program);
    const LpResult b = solve(other);
    ASSERT_TRUE(check(program, a));
    ASSERT_TRUE(check(other, b));
    ASSERT_EQ(status(a), status(b)) << print(program) << "\n" << print(other);
    if (status(a) == Status::kOptimal) {
      ASSERT_EQ(value(a), value(b)) << print(program);
    }
  }
}

/// The dual of min c.x as a program of its own: max y.b is -min -b.y.
LinearProgram dual_of(const LinearProgram& program) {
  LinearProgram dual;
  const std::size_t m = program.row_count();
  std::vector<Rational> signs(m);
  std::vector<Rational> objective(m);
  for (std::size_t i = 0; i < m; ++i) {
    const Relation relation = program.row(i).relation;
    dual.add_variable(relation == Relation::kEqual ? VariableKind::kFree
                                                   : VariableKind::kNonNegative);
    signs[i] = relation == Relation::kLessEqual ? -1 : 1;
    objective[i] = -signs[i] * program.row(i).rhs;
  }
  for (std::size_t j = 0; j < program.variable_count(); ++j) {
    std::vector<Rational> row(m);
    for (std::size_t i = 0; i < m; ++i) row[i] = signs[i] * at(program.row(i).coefficients, j);
    dual.add_row(
        row, program.kind(j) == VariableKind::kFree ? Relation::kEqual : Relation::kLessEqual,
        at(program.objective(), j));
  }
  dual.minimize(objective);
  return dual;
}

TEST(LpProperty, Duality) {
  std::mt19937 random(22);
  for (int k = 0; k < 2000; ++k) {
    const LinearProgram program = random_program(random, 6, 8);
    const LinearProgram dual = dual_of(program);
    const LpResult a = solve(program);
    const LpResult b = solve(dual);
    ASSERT_TRUE(check(program, a));
    ASSERT_TRUE(check(dual, b));
    switch (status(a)) {
      case Status::kOptimal:
        ASSERT_EQ(status(b), Status::kOptimal) << print(program);
        ASSERT_EQ(value(a), -value(b));
        break;
      case Status::kUnbounded:
        ASSERT_EQ(status(b), Status::kInfeasible) << print(program);
        break;
      case Status::kInfeasible:
        ASSERT_NE(status(b), Status::kOptimal) << print(program);
        break;
    }
  }
}

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
