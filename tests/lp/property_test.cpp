// SPDX-License-Identifier: GPL-3.0-or-later
// The same input has the same output, to the last counter, in every thread; optima are those of
// the best vertex, and of the dual program.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

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

/// The one x with these rows, by elimination; nothing if there is none or are several.
std::optional<std::vector<Rational>> solved(std::vector<std::vector<Rational>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && rows[pivot][k].is_zero()) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(rows[pivot], rows[k]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || rows[i][k].is_zero()) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<Rational> x;
  for (std::size_t k = 0; k < n; ++k) x.push_back(rows[k][n] / rows[k][k]);
  return x;
}

/// Half-spaces a.x <= b of a box and of random cuts, as (a, b).
std::vector<std::vector<Rational>> random_polytope(std::mt19937& random, std::size_t n) {
  std::vector<std::vector<Rational>> planes;
  for (std::size_t j = 0; j < n; ++j) {
    for (const int sign : {-1, 1}) {
      planes.emplace_back(n + 1);
      planes.back()[j] = sign;
      planes.back()[n] = Rational(draw(random, 1, 6), 2);
    }
  }
  for (int cuts = draw(random, 0, 4); cuts > 0; --cuts) {
    planes.emplace_back();
    for (std::size_t j = 0; j <= n; ++j) planes.back().emplace_back(draw(random, -3, 3));
  }
  return planes;
}

/// The least c.x over all vertices, by trying all sets of n planes.
std::optional<Rational> best_vertex(const std::vector<std::vector<Rational>>& planes,
                                    const std::vector<Rational>& c) {
  const std::size_t n = c.size();
  std::optional<Rational> best;
  for (unsigned chosen = 0; chosen < 1U << planes.size(); ++chosen) {
    std::vector<std::vector<Rational>> rows;
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if ((chosen >> k) % 2 == 1) rows.push_back(planes[k]);
    }
    if (rows.size() != n) continue;
    const auto x = solved(std::move(rows));
    if (!x) continue;
    const auto sum = [&](const std::vector<Rational>& a) {
      Rational value = 0;
      for (std::size_t j = 0; j < n; ++j) value += a[j] * (*x)[j];
      return value;
    };
    const bool is_inside = std::all_of(planes.begin(), planes.end(),
                                       [&](const auto& p) { return sum(p) <= p[n]; });
    if (is_inside && (!best || sum(c) < *best)) best = sum(c);
  }
  return best;
}

// The optimum over a polytope is at a vertex. It is that of the dual program: max -b.y with
// A^T y = -c, y >= 0; and of the program in other words: rows in another order, turned round
// and scaled.
TEST(LpProperty, OptimaAreThoseOfTheBestVertexAndOfTheDual) {
  std::mt19937 random(29);
  int empty = 0;
  for (int round = 0; round < 300; ++round) {
    const auto n = static_cast<std::size_t>(draw(random, 1, 3));
    const auto planes = random_polytope(random, n);
    std::vector<Rational> c;
    while (c.size() < n) c.emplace_back(draw(random, -4, 4), draw(random, 1, 3));
    LinearProgram program;
    LinearProgram reworded;
    program.add_variables(n, VariableKind::kFree);
    reworded.add_variables(n, VariableKind::kFree);
    for (const auto& p : planes) {
      program.add_row({p.begin(), p.end() - 1}, Relation::kLessEqual, p[n]);
    }
    for (auto p = planes.rbegin(); p != planes.rend(); ++p) {
      const Rational factor(-draw(random, 1, 5), draw(random, 1, 5));
      std::vector<Rational> row;
      for (std::size_t j = 0; j < n; ++j) row.push_back(factor * (*p)[j]);
      reworded.add_row(std::move(row), Relation::kGreaterEqual, factor * (*p)[n]);
    }
    program.minimize(c);
    reworded.minimize(c);
    LinearProgram dual;
    dual.add_variables(planes.size(), VariableKind::kNonNegative);
    std::vector<Rational> cost;
    for (const auto& p : planes) cost.push_back(p[n]);
    for (std::size_t j = 0; j < n; ++j) {
      std::vector<Rational> column;
      for (const auto& p : planes) column.push_back(p[j]);
      dual.add_row(std::move(column), Relation::kEqual, -c[j]);
    }
    dual.minimize(cost);
    const std::optional<Rational> best = best_vertex(planes, c);
    const LpResult result = solve(program);
    const LpResult of_dual = solve(dual);
    SCOPED_TRACE(print(program));
    if (!best) {
      ++empty;
      EXPECT_EQ(status(result), Status::kInfeasible);
      EXPECT_EQ(status(solve(reworded)), Status::kInfeasible);
      EXPECT_EQ(status(of_dual), Status::kUnbounded);
      continue;
    }
    ASSERT_EQ(status(result), Status::kOptimal);
    EXPECT_EQ(value(result), *best);
    EXPECT_EQ(value(solve(reworded)), *best);
    ASSERT_EQ(status(of_dual), Status::kOptimal);
    EXPECT_EQ(value(of_dual), -*best);
  }
  EXPECT_GE(empty, 20);
}

}  // namespace
}  // namespace stickslip::lp_test
