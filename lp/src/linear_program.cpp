// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/lp/linear_program.hpp"

#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {

std::size_t LinearProgram::add_variable(VariableKind kind) {
  kinds_.push_back(kind);
  return kinds_.size() - 1;
}

std::size_t LinearProgram::add_variables(std::size_t count, VariableKind kind) {
  const std::size_t first = kinds_.size();
  kinds_.resize(first + count, kind);
  return first;
}

std::size_t LinearProgram::add_row(std::vector<Rational> coefficients, Relation relation,
                                   Rational rhs) {
  require(coefficients.size() <= kinds_.size(),
          "LinearProgram::add_row: more coefficients than variables");
  rows_.push_back(LpRow{std::move(coefficients), relation, std::move(rhs)});
  return rows_.size() - 1;
}

void LinearProgram::minimize(std::vector<Rational> objective) {
  require(objective.size() <= kinds_.size(),
          "LinearProgram::minimize: more coefficients than variables");
  objective_ = std::move(objective);
}

}  // namespace stickslip
