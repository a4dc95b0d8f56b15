// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_program.hpp"

#include <utility>

namespace stickslip::lp_test {
namespace {

enum class Style { kSigns, kSmall, kFractions, kWide, kCount };

Rational number(std::mt19937& random, Style style) {
  switch (style) {
    case Style::kSigns:
      return draw(random, -1, 1);
    case Style::kSmall:
      return draw(random, -5, 5);
    case Style::kFractions:
      return Rational(draw(random, -9, 9), draw(random, 1, 7));
    default:
      return Rational(draw(random, -1000000, 1000000), draw(random, 1, 1000000));
  }
}

}  // namespace

int draw(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

LinearProgram random_program(std::mt19937& random, int max_variables, int max_rows) {
  const auto style = static_cast<Style>(draw(random, 0, static_cast<int>(Style::kCount) - 1));
  const int shape = draw(random, 0, 3);  // inequalities, equations, mixed twice
  const int sparsity = draw(random, 0, 2);
  const bool zero_rhs = draw(random, 0, 4) == 0;
  const bool through_point = draw(random, 0, 2) != 0;  // then feasible, often degenerate
  const auto n = static_cast<std::size_t>(draw(random, 1, max_variables));
  const auto m = static_cast<std::size_t>(draw(random, 1, max_rows));

  LinearProgram program;
  std::vector<Rational> point(n);
  for (std::size_t j = 0; j < n; ++j) {
    const bool is_free = shape == 0 || (shape != 1 && draw(random, 0, 1) == 0);
    program.add_variable(is_free ? VariableKind::kFree : VariableKind::kNonNegative);
    point[j] = zero_rhs ? Rational(0) : number(random, style);
    if (!is_free) point[j] = draw(random, 0, 1) == 0 ? Rational(0) : Rational(abs(point[j]));
  }
  for (std::size_t i = 0; i < m; ++i) {
    if (i > 0 && draw(random, 0, 9) == 0) {  // twice the same row, in other words
      LpRow row =
          program.row(static_cast<std::size_t>(draw(random, 0, static_cast<int>(i) - 1)));
      const Rational factor(draw(random, 1, 5), draw(random, 1, 5));
      for (Rational& value : row.coefficients) value *= factor;
      program.add_row(std::move(row.coefficients), row.relation, row.rhs * factor);
      continue;
    }
    std::vector<Rational> coefficients(n);
    Rational at_point = 0;
    for (std::size_t j = 0; j < n; ++j) {
      if (sparsity > 0 && draw(random, 0, sparsity) != 0) continue;
      coefficients[j] = number(random, style);
      at_point += coefficients[j] * point[j];
    }
    const int pick = shape == 0 ? draw(random, 0, 1) : shape == 1 ? 2 : draw(random, 0, 2);
    const Relation relation = pick == 0   ? Relation::kLessEqual
                              : pick == 1 ? Relation::kGreaterEqual
                                          : Relation::kEqual;
    Rational rhs = zero_rhs ? Rational(0) : number(random, style);
    if (through_point) {
      const Rational slack = draw(random, 0, 2) == 0 ? Rational(abs(rhs)) : Rational(0);
      rhs = relation == Relation::kLessEqual      ? Rational(at_point + slack)
            : relation == Relation::kGreaterEqual ? Rational(at_point - slack)
                                                  : at_point;
    }
    program.add_row(std::move(coefficients), relation, std::move(rhs));
  }
  if (draw(random, 0, 2) != 0) {
    std::vector<Rational> objective(n);
    const bool positive = draw(random, 0, 1) == 0;
    for (Rational& value : objective) {
      value = number(random, style);
      if (positive) value = abs(value);
    }
    program.minimize(std::move(objective));
  }
  return program;
}

}  // namespace stickslip::lp_test
