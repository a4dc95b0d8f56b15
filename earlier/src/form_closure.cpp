// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/form_closure.hpp"

#include "spatial_cells.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {
namespace {

FreeMotion checked(const std::vector<RationalRow>& normals, const RationalRow& d) {
  FreeMotion motion{primitive_multiple(d)};
  require(!is_zero(motion.motion), "a free motion is zero");
  for (const RationalRow& n : normals) {
    require(dot(n, d).sign() >= 0, "a free motion penetrates a contact");
  }
  return motion;
}

FormClosure checked(const std::vector<RationalRow>& normals, FormClosure closure) {
  for (std::size_t j = 0; j < closure.spanning.size(); ++j) {
    Rational sum = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      require(closure.multipliers[i].sign() > 0,
              "a multiplier of form closure is not positive");
      sum += closure.multipliers[i] * normals[i][j];
    }
    require(sum.is_zero(), "the multipliers of form closure do not give zero");
  }
  return closure;
}

/// Returns the first normals that are linearly independent.
std::vector<ContactId> spanning(const std::vector<RationalRow>& normals, std::size_t motions) {
  std::vector<ContactId> picked;
  std::vector<RationalRow> rows;
  for (std::size_t i = 0; i < normals.size() && rows.size() < motions; ++i) {
    rows.push_back(normals[i]);
    if (rank_of(rows) < rows.size()) {
      rows.pop_back();
    } else {
      picked.emplace_back(i);
    }
  }
  return picked;
}

/// Returns a row that is not 0 and orthogonal to all normals, which must not span.
RationalRow orthogonal(const std::vector<RationalRow>& normals, std::size_t motions) {
  return null_space(matrix_of(normals, motions)).back();
}

}  // namespace

std::variant<FormClosure, FreeMotion> form_closure(const std::vector<RationalRow>& normals,
                                                   std::size_t motions) {
  // The program is sum (1 + x_i) N_i = 0, x >= 0: any positive multipliers are of this form, up
  // to a common factor.
  LinearProgram program;
  program.add_variables(normals.size(), VariableKind::kNonNegative);
  for (std::size_t j = 0; j < motions; ++j) {
    RationalRow coefficients;
    Rational sum = 0;
    for (const RationalRow& n : normals) {
      coefficients.push_back(n[j]);
      sum += n[j];
    }
    program.add_row(std::move(coefficients), Relation::kEqual, -sum);
  }
  const LpResult result = solve(program);
  if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
    RationalRow d;
    for (std::size_t j = 0; j < motions; ++j) d.push_back(-infeasible->farkas[j]);
    return checked(normals, d);
  }
  FormClosure closure{std::get<Optimal>(result).point, spanning(normals, motions)};
  if (closure.spanning.size() < motions) return checked(normals, orthogonal(normals, motions));
  for (Rational& multiplier : closure.multipliers) multiplier += 1;
  return checked(normals, std::move(closure));
}

std::variant<FormClosure, FreeMotion> form_closure(const Problem& problem) {
  std::vector<RationalRow> normals;
  for (const ContactRow& row : problem.rows()) {
    const Vector3 n = coordinates(row.normal);
    normals.emplace_back(n.begin(), n.end());
  }
  return form_closure(normals, 3);
}

std::variant<FormClosure, FreeMotion> form_closure(const GraspBox& grasp) {
  std::vector<RationalRow> normals;
  for (const earlier_detail::FrictionDisc& disc : earlier_detail::discs_of(grasp)) {
    normals.emplace_back(disc.normal_row().begin(), disc.normal_row().end());
  }
  return form_closure(normals, 6);
}

}  // namespace stickslip
