// SPDX-License-Identifier: GPL-3.0-or-later
#include "qp_oracle.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

namespace stickslip::lp_test {
namespace {

CGAL::Gmpq to_gmpq(const Rational& value) {
  return CGAL::Gmpq(value.gmp());
}

CGAL::Comparison_result to_cgal(Relation relation) {
  switch (relation) {
    case Relation::kLessEqual:
      return CGAL::SMALLER;
    case Relation::kGreaterEqual:
      return CGAL::LARGER;
    case Relation::kEqual:
      break;
  }
  return CGAL::EQUAL;
}

}  // namespace

OracleAnswer ask_qp_solver(const LinearProgram& program) {
  using Number = CGAL::Gmpq;
  CGAL::Quadratic_program<Number> qp(CGAL::SMALLER, false, Number(0), false, Number(0));
  for (std::size_t j = 0; j < program.variable_count(); ++j) {
    const auto index = static_cast<int>(j);
    qp.set_l(index, program.kind(j) == VariableKind::kNonNegative, Number(0));
    qp.set_u(index, false, Number(0));
    qp.set_c(index,
             j < program.objective().size() ? to_gmpq(program.objective()[j]) : Number(0));
  }
  for (std::size_t i = 0; i < program.row_count(); ++i) {
    const LpRow& row = program.row(i);
    const auto index = static_cast<int>(i);
    for (std::size_t j = 0; j < row.coefficients.size(); ++j) {
      qp.set_a(static_cast<int>(j), index, to_gmpq(row.coefficients[j]));
    }
    qp.set_b(index, to_gmpq(row.rhs));
    qp.set_r(index, to_cgal(row.relation));
  }
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);
  const auto solution = CGAL::solve_linear_program(qp, Number(), options);
  OracleAnswer answer;
  if (solution.is_infeasible()) {
    answer.status = Status::kInfeasible;
  } else if (solution.is_unbounded()) {
    answer.status = Status::kUnbounded;
  } else {
    const CGAL::Quotient<Number> value = solution.objective_value();
    const CGAL::Gmpq quotient = value.numerator() / value.denominator();
    mpq_set(answer.value.mutable_gmp(), quotient.mpq());
  }
  return answer;
}

}  // namespace stickslip::lp_test
