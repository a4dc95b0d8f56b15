// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/lp/exact_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace stickslip {
namespace {

/// A literal twin: Gaussian elimination with fractions, by the same pivots.
struct Fractions {
  RationalMatrix a;
  RationalRow b;
  std::vector<std::size_t> order{};
  std::size_t rank = 0;

  void eliminate() {
    for (std::size_t k = 0; k < a.columns(); ++k) order.push_back(k);
    while (rank < std::min(a.rows(), a.columns()) && take_pivot()) ++rank;
  }
  bool take_pivot() {
    std::size_t row = rank;
    std::size_t column = rank;
    for (std::size_t k = rank; k < a.columns(); ++k) {
      for (std::size_t j = rank; j < a.rows(); ++j) {
        if (Rational(abs(a(j, k))) > Rational(abs(a(row, column)))) row = j, column = k;
      }
    }
    if (a(row, column).is_zero()) return false;
    for (std::size_t k = 0; k < a.columns(); ++k) std::swap(a(row, k), a(rank, k));
    for (std::size_t j = 0; j < a.rows(); ++j) std::swap(a(j, column), a(j, rank));
    std::swap(b[row], b[rank]);
    std::swap(order[column], order[rank]);
    for (std::size_t j = rank + 1; j < a.rows(); ++j) {
      const Rational factor = a(j, rank) / a(rank, rank);
      for (std::size_t k = rank; k < a.columns(); ++k) a(j, k) -= factor * a(rank, k);
      b[j] -= factor * b[rank];
    }
    return true;
  }
  std::optional<RationalRow> solution() const {
    for (std::size_t j = rank; j < b.size(); ++j) {
      if (!b[j].is_zero()) return std::nullopt;
    }
    RationalRow x(a.columns());
    for (std::size_t j = rank; j-- > 0;) {
      Rational value = b[j];
      for (std::size_t k = j + 1; k < rank; ++k) value -= a(j, k) * x[order[k]];
      x[order[j]] = value / a(j, j);
    }
    return x;
  }
};

class Systems {
 public:
  int between(int low, int high) {
    return low + static_cast<int>(generator_() % static_cast<unsigned>(high - low + 1));
  }
  Rational number() {
    const int kind = between(0, 5);
    if (kind == 0) return 0;
    if (kind == 1) return Rational(between(-3, 3), between(1, 9));
    if (kind == 2) return rational_from_double(between(-1000, 1000) / 7.0);
    return between(-2, 2);
  }
  /// A product of two matrices, so that ranks of all sizes occur.
  RationalMatrix matrix(std::size_t rows, std::size_t columns) {
    const auto inner = static_cast<std::size_t>(between(0, 4));
    RationalMatrix result(rows, columns);
    RationalMatrix left(rows, inner);
    RationalMatrix right(inner, columns);
    for (std::size_t i = 0; i < inner; ++i) {
      for (std::size_t j = 0; j < rows; ++j) left(j, i) = number();
      for (std::size_t k = 0; k < columns; ++k) right(i, k) = number();
    }
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t k = 0; k < columns; ++k) {
        for (std::size_t i = 0; i < inner; ++i) result(j, k) += left(j, i) * right(i, k);
      }
    }
    return result;
  }

 private:
  std::mt19937 generator_{5};
};

TEST(ExactSystem, AnswersAsALiteralTwinWithFractions) {
  Systems systems;
  std::size_t solved = 0;
  std::size_t unsolvable = 0;
  std::size_t deficient = 0;
  for (int round = 0; round < 400; ++round) {
    const auto rows = static_cast<std::size_t>(systems.between(1, 5));
    const auto columns = static_cast<std::size_t>(systems.between(1, 5));
    const RationalMatrix a = systems.matrix(rows, columns);
    RationalRow b(rows);
    if (systems.between(0, 1) == 0) {
      RationalRow x(columns);
      for (Rational& entry : x) entry = systems.number();
      b = a * x;
    } else {
      for (Rational& entry : b) entry = systems.number();
    }
    Fractions twin{a, b};
    twin.eliminate();
    EXPECT_EQ(rank_of(a), twin.rank);
    const auto solution = solve_exactly(a, b);
    EXPECT_EQ(solution, twin.solution());
    EXPECT_EQ(solve_exactly(a, b, true).has_value(), solution && twin.rank == columns);
    if (solution) {
      EXPECT_EQ(a * *solution, b);
    }
    const std::vector<RationalRow> free = null_space(a);
    EXPECT_EQ(free.size(), columns - twin.rank);
    EXPECT_EQ(rank_of(free), free.size());
    for (const RationalRow& way : free) EXPECT_EQ(a * way, RationalRow(rows));
    ++(solution ? solved : unsolvable);
    deficient += twin.rank < std::min(rows, columns);
  }
  EXPECT_GT(std::min({solved, unsolvable, deficient}), 50u);
}

TEST(ExactSystem, WithoutRowsEverythingIsASolution) {
  EXPECT_EQ(null_space(RationalMatrix(0, 2)).size(), 2u);
  EXPECT_EQ(solve_exactly(RationalMatrix(0, 2), {}), RationalRow(2));
  EXPECT_EQ(rank_of(std::vector<RationalRow>{}), 0u);
}

}  // namespace
}  // namespace stickslip
