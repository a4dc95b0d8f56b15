// SPDX-License-Identifier: GPL-3.0-or-later
// Every system of up to three rows in two variables with coefficients and right-hand sides in
// {-1, 0, 1}, against Fourier-Motzkin elimination.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

#include "evidence_check.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {
namespace {

/// a0 x0 + a1 x1 + a2 z <= b, as {a0, a1, a2, b}.
using Halfspace = std::array<std::int64_t, 4>;

struct SmallRow {
  int a0;
  int a1;
  int rhs;
  Relation relation;
};

std::vector<SmallRow> all_rows() {
  std::vector<SmallRow> rows;
  for (int a0 = -1; a0 <= 1; ++a0) {
    for (int a1 = -1; a1 <= 1; ++a1) {
      for (int rhs = -1; rhs <= 1; ++rhs) {
        for (const Relation relation :
             {Relation::kLessEqual, Relation::kEqual, Relation::kGreaterEqual}) {
          rows.push_back({a0, a1, rhs, relation});
        }
      }
    }
  }
  return rows;
}

Halfspace primitive(Halfspace h) {
  std::int64_t divisor = 0;
  for (const std::int64_t value : h) divisor = std::gcd(divisor, value);
  if (divisor > 1) {
    for (std::int64_t& value : h) value /= divisor;
  }
  return h;
}

std::set<Halfspace> eliminate(const std::set<Halfspace>& system, std::size_t variable) {
  std::set<Halfspace> out;
  for (const Halfspace& p : system) {
    if (p[variable] == 0) out.insert(p);
    if (p[variable] <= 0) continue;
    for (const Halfspace& q : system) {
      if (q[variable] >= 0) continue;
      Halfspace sum{};
      for (std::size_t k = 0; k < 4; ++k) sum[k] = -q[variable] * p[k] + p[variable] * q[k];
      out.insert(primitive(sum));
    }
  }
  return out;
}

struct Truth {
  Status status;
  Rational value;
};

/// The least z with z >= c.x over the system: project on z.
Truth decide(const std::vector<SmallRow>& rows, const std::array<bool, 2>& is_free, int c0,
             int c1) {
  std::set<Halfspace> system;
  system.insert({c0, c1, -1, 0});
  for (const SmallRow& row : rows) {
    const Halfspace upper = {row.a0, row.a1, 0, row.rhs};
    const Halfspace lower = {-row.a0, -row.a1, 0, -row.rhs};
    if (row.relation != Relation::kGreaterEqual) system.insert(upper);
    if (row.relation != Relation::kLessEqual) system.insert(lower);
  }
  if (!is_free[0]) system.insert({-1, 0, 0, 0});
  if (!is_free[1]) system.insert({0, -1, 0, 0});
  system = eliminate(eliminate(system, 0), 1);
  std::optional<Rational> least;
  for (const Halfspace& h : system) {  // a z <= b, where a <= 0
    if (h[2] == 0) {
      if (h[3] < 0) return {Status::kInfeasible, 0};
    } else {
      const Rational bound(-h[3], -h[2]);
      least = least ? std::max(*least, bound) : bound;
    }
  }
  if (!least) return {Status::kUnbounded, 0};
  return {Status::kOptimal, *least};
}

void compare(const std::vector<SmallRow>& rows, const std::array<bool, 2>& is_free, int c0,
             int c1) {
  LinearProgram program;
  for (const bool f : is_free) {
    program.add_variable(f ? VariableKind::kFree : VariableKind::kNonNegative);
  }
  for (const SmallRow& row : rows) program.add_row({row.a0, row.a1}, row.relation, row.rhs);
  if (c0 != 0 || c1 != 0) program.minimize({c0, c1});
  const Truth truth = decide(rows, is_free, c0, c1);
  const LpResult result = solve(program);
  ASSERT_TRUE(check(program, result));
  ASSERT_EQ(status(result), truth.status) << print(program);
  if (truth.status == Status::kOptimal) {
    ASSERT_EQ(value(result), truth.value) << print(program);
  }
}

constexpr std::array<std::array<bool, 2>, 3> kKinds = {
    {{true, true}, {true, false}, {false, false}}};

TEST(LpSmallWorld, UpToTwoRowsAllObjectives) {
  const std::vector<SmallRow> rows = all_rows();
  for (const auto& is_free : kKinds) {
    for (int c0 = -1; c0 <= 1; ++c0) {
      for (int c1 = -1; c1 <= 1; ++c1) {
        compare({}, is_free, c0, c1);
        for (std::size_t i = 0; i < rows.size(); ++i) {
          compare({rows[i]}, is_free, c0, c1);
          for (std::size_t k = i; k < rows.size(); ++k) {
            compare({rows[i], rows[k]}, is_free, c0, c1);
          }
          ASSERT_FALSE(HasFatalFailure());
        }
      }
    }
  }
}

TEST(LpSmallWorld, ThreeRowsFeasibility) {
  const std::vector<SmallRow> rows = all_rows();
  for (const auto& is_free : kKinds) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = i; k < rows.size(); ++k) {
        for (std::size_t l = k; l < rows.size(); ++l) {
          compare({rows[i], rows[k], rows[l]}, is_free, 0, 0);
        }
        ASSERT_FALSE(HasFatalFailure());
      }
    }
  }
}

TEST(LpSmallWorld, ThreeRowsObjectivesInTurn) {
  const std::vector<SmallRow> rows = all_rows();
  std::size_t turn = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = i; k < rows.size(); ++k) {
      for (std::size_t l = k; l < rows.size(); ++l) {
        const auto c0 = static_cast<int>(turn % 3) - 1;
        const auto c1 = static_cast<int>(turn / 3 % 3) - 1;
        compare({rows[i], rows[k], rows[l]}, kKinds[turn / 9 % 3], c0, c1);
        ++turn;
      }
      ASSERT_FALSE(HasFatalFailure());
    }
  }
}

}  // namespace
}  // namespace stickslip::lp_test
