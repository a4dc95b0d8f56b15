// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence_check.hpp"

#include <sstream>

namespace stickslip::lp_test {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

Rational coefficient(const std::vector<Rational>& values, std::size_t j) {
  return j < values.size() ? values[j] : Rational(0);
}

Rational dot(const std::vector<Rational>& values, const std::vector<Rational>& x) {
  Rational sum = 0;
  for (std::size_t j = 0; j < x.size(); ++j) sum += coefficient(values, j) * x[j];
  return sum;
}

/// Rows with right-hand sides times `scale`.
AssertionResult check_primal(const LinearProgram& program, const std::vector<Rational>& x,
                             const Rational& scale) {
  if (x.size() != program.variable_count()) return AssertionFailure() << "wrong length";
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (program.kind(j) == VariableKind::kNonNegative && x[j] < 0) {
      return AssertionFailure() << "x" << j << " = " << x[j];
    }
  }
  for (std::size_t i = 0; i < program.row_count(); ++i) {
    const LpRow& row = program.row(i);
    const Rational left = dot(row.coefficients, x);
    const Rational right = row.rhs * scale;
    const bool holds = row.relation == Relation::kEqual       ? left == right
                       : row.relation == Relation::kLessEqual ? left <= right
                                                              : left >= right;
    if (!holds)
      return AssertionFailure() << "row " << i << ": " << left << " against " << right;
  }
  return AssertionSuccess();
}

AssertionResult check_admissible(const LinearProgram& program, const std::vector<Rational>& y) {
  if (y.size() != program.row_count()) return AssertionFailure() << "wrong length";
  for (std::size_t i = 0; i < y.size(); ++i) {
    const Relation relation = program.row(i).relation;
    if ((relation == Relation::kLessEqual && y[i] > 0) ||
        (relation == Relation::kGreaterEqual && y[i] < 0)) {
      return AssertionFailure() << "y" << i << " = " << y[i];
    }
  }
  return AssertionSuccess();
}

/// (c - yA)_j = 0 for free x_j, >= 0 otherwise.
AssertionResult check_reduced_costs(const LinearProgram& program,
                                    const std::vector<Rational>& objective,
                                    const std::vector<Rational>& y) {
  for (std::size_t j = 0; j < program.variable_count(); ++j) {
    Rational reduced = coefficient(objective, j);
    for (std::size_t i = 0; i < y.size(); ++i) {
      reduced -= y[i] * coefficient(program.row(i).coefficients, j);
    }
    const bool holds = program.kind(j) == VariableKind::kFree ? reduced == 0 : reduced >= 0;
    if (!holds) return AssertionFailure() << "reduced cost " << j << " = " << reduced;
  }
  return AssertionSuccess();
}

Rational dual_value(const LinearProgram& program, const std::vector<Rational>& y) {
  Rational sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) sum += y[i] * program.row(i).rhs;
  return sum;
}

AssertionResult check_one(const LinearProgram& program, const Optimal& evidence) {
  if (AssertionResult r = check_primal(program, evidence.point, 1); !r) return r;
  if (AssertionResult r = check_admissible(program, evidence.dual); !r) return r;
  if (AssertionResult r = check_reduced_costs(program, program.objective(), evidence.dual);
      !r) {
    return r;
  }
  if (dot(program.objective(), evidence.point) != evidence.value) {
    return AssertionFailure() << "c.x is not the value";
  }
  if (dual_value(program, evidence.dual) != evidence.value) {
    return AssertionFailure() << "y.b is not the value";
  }
  return AssertionSuccess();
}

AssertionResult check_one(const LinearProgram& program, const Infeasible& evidence) {
  if (AssertionResult r = check_admissible(program, evidence.farkas); !r) return r;
  if (AssertionResult r = check_reduced_costs(program, {}, evidence.farkas); !r) return r;
  if (dual_value(program, evidence.farkas) <= 0) return AssertionFailure() << "y.b <= 0";
  Integer divisor = 0;
  for (const Rational& y : evidence.farkas) {
    if (denominator(y) != 1) return AssertionFailure() << "Farkas vector not integral";
    divisor = gcd(divisor, numerator(y));
  }
  if (divisor != 1) return AssertionFailure() << "Farkas vector not coprime";
  return AssertionSuccess();
}

AssertionResult check_one(const LinearProgram& program, const Unbounded& evidence) {
  if (AssertionResult r = check_primal(program, evidence.point, 1); !r) return r;
  if (AssertionResult r = check_primal(program, evidence.ray, 0); !r) return r;
  if (dot(program.objective(), evidence.ray) >= 0) return AssertionFailure() << "c.d >= 0";
  return AssertionSuccess();
}

}  // namespace

AssertionResult check(const LinearProgram& program, const LpResult& result) {
  const AssertionResult outcome =
      std::visit([&](const auto& evidence) { return check_one(program, evidence); }, result);
  if (outcome) return outcome;
  return AssertionFailure() << status(result) << ": " << outcome.message() << "\n"
                            << print(program);
}

Status status(const LpResult& result) {
  return static_cast<Status>(result.index());
}

std::ostream& operator<<(std::ostream& out, Status status) {
  constexpr const char* kNames[] = {"optimal", "infeasible", "unbounded"};
  return out << kNames[static_cast<int>(status)];
}

const Rational& value(const LpResult& result) {
  return std::get<Optimal>(result).value;
}

std::string print(const LinearProgram& program) {
  std::ostringstream out;
  const auto linear = [&](const std::vector<Rational>& values) {
    for (const Rational& value : values) out << value << ' ';
  };
  out << "kinds ";
  for (std::size_t j = 0; j < program.variable_count(); ++j) {
    out << (program.kind(j) == VariableKind::kFree ? 'f' : '+');
  }
  out << "\nminimize ";
  linear(program.objective());
  for (std::size_t i = 0; i < program.row_count(); ++i) {
    const LpRow& row = program.row(i);
    out << '\n';
    linear(row.coefficients);
    out << (row.relation == Relation::kEqual       ? "= "
            : row.relation == Relation::kLessEqual ? "<= "
                                                   : ">= ")
        << row.rhs;
  }
  return out.str();
}

}  // namespace stickslip::lp_test
