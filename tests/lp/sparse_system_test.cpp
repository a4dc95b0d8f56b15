// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/lp/sparse_system.hpp"

#include <gtest/gtest.h>

#include <random>

#include "stickslip/lp/exact_system.hpp"

namespace stickslip {
namespace {

/// Columns of a few small fractions, some of which depend on those before them.
std::vector<SparseRow> random_columns(std::mt19937& random, std::size_t rows, std::size_t n) {
  std::vector<SparseRow> columns;
  const auto number = [&](int most) { return static_cast<int>(random() % most); };
  for (std::size_t j = 0; j < n; ++j) {
    SparseRow& column = columns.emplace_back();
    if (j > 1 && number(4) == 0) {  // the sum of two
      RationalRow sum(rows);
      add_multiple(sum, 1, columns[number(static_cast<int>(j))]);
      add_multiple(sum, Rational(-2, 3), columns[number(static_cast<int>(j))]);
      for (std::size_t row = 0; row < rows; ++row) {
        if (!sum[row].is_zero()) column.emplace_back(row, sum[row]);
      }
      continue;
    }
    for (std::size_t row = 0; row < rows; ++row) {
      if (number(3) != 0) continue;
      const Rational entry(number(2001) - 1000, 1 + number(7));
      if (!entry.is_zero()) column.emplace_back(row, entry);
    }
  }
  return columns;
}

RationalMatrix dense(const std::vector<SparseRow>& columns, std::size_t rows) {
  std::vector<RationalRow> full;
  for (const SparseRow& column : columns) add_multiple(full.emplace_back(rows), 1, column);
  return matrix_of_columns(full, rows);
}

TEST(SparseSystem, SolvesWhatEliminationWithFractionsSolves) {
  std::mt19937 random(7);
  int solved = 0;
  int without = 0;
  for (int round = 0; round < 200; ++round) {
    const std::size_t rows = 1 + random() % 9;
    const std::vector<SparseRow> columns = random_columns(random, rows, 1 + random() % 12);
    const RationalMatrix a = dense(columns, rows);
    const SparseSystem system(rows, columns);
    EXPECT_EQ(system.independent().size(), rank_of(a));
    RationalRow b;
    for (std::size_t row = 0; row < rows; ++row) {
      b.emplace_back(static_cast<int>(random() % 100), 1 + static_cast<int>(random() % 5));
    }
    const auto x = system.solve(b);
    EXPECT_EQ(x.has_value(), solve_exactly(a, b).has_value());
    ++(x ? solved : without);
    if (x) {
      EXPECT_EQ(a * x->row(), b);
    }
  }
  EXPECT_GT(solved, 20);
  EXPECT_GT(without, 20);
}

TEST(SparseSystem, KeepsTheFirstOfDependentColumns) {
  const SparseSystem system(2, {{{0, 1}}, {{0, Rational(5, 3)}}, {}, {{0, 1}, {1, 2}}});
  EXPECT_EQ(system.independent(), (std::vector<std::size_t>{0, 3}));
  EXPECT_EQ(system.solve({1, 1})->row(), (RationalRow{Rational(1, 2), 0, 0, Rational(1, 2)}));
}

/// The matrix of Hilbert, whose inverse has large integers: its sums are known.
TEST(SparseSystem, FindsLongSolutions) {
  constexpr std::size_t kSize = 60;
  std::vector<SparseRow> columns(kSize);
  for (std::size_t j = 0; j < kSize; ++j) {
    for (std::size_t i = 0; i < kSize; ++i) {
      columns[j].emplace_back(i, Rational(1, static_cast<int>(i + j + 1)));
    }
  }
  const auto solution = SparseSystem(kSize, columns).solve(RationalRow(kSize, Rational(1)));
  ASSERT_TRUE(solution);
  const RationalRow x = solution->row();
  Rational sum = 0;  // of all entries of the inverse
  for (const Rational& entry : x) sum += entry;
  EXPECT_EQ(sum, static_cast<int>(kSize * kSize));
  EXPECT_GT(msb(abs(numerator(x[kSize / 2]))), 100U);
}

TEST(SparseSystem, TakesNumbersThatThePrimeDivides) {
  const Rational prime((1L << 31) - 1);
  const SparseSystem system(1, {{{0, prime}}});
  EXPECT_TRUE(system.independent().empty());  // it is left out, and says nothing false
  EXPECT_FALSE(system.solve({1}));
  EXPECT_EQ(SparseSystem(1, {{{0, 1}}}).solve({prime})->row(), RationalRow{prime});
}

TEST(SparseSystem, HasAnEmptySide) {
  EXPECT_EQ(SparseSystem(0, {}).solve({})->row(), RationalRow{});
  EXPECT_FALSE(SparseSystem(1, {}).solve({2}));
  EXPECT_EQ(SparseSystem(1, {{}}).solve({0})->row(), RationalRow{0});
}

}  // namespace
}  // namespace stickslip
