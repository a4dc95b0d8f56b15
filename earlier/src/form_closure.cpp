// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/form_closure.hpp"

#include <algorithm>

#include "contact_forces.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// Vectors picked greedily so that they are linearly independent.
class Span {
 public:
  explicit Span(const std::vector<IntegerVector3>& vectors) {
    for (std::size_t i = 0; i < vectors.size() && picked_.size() < 3; ++i) {
      const IntegerVector3& v = vectors[i];
      if (picked_.empty() ? !is_zero(v)
          : picked_.size() == 1
              ? !is_zero(cross(vectors[picked_[0]], v))
              : !dot(cross(vectors[picked_[0]], vectors[picked_[1]]), v).is_zero()) {
        picked_.push_back(i);
      }
    }
    if (picked_.size() == 1) {
      // At most one axis is parallel to the vector.
      orthogonal_ = cross(vectors[picked_[0]], {0, 0, 1});
      if (is_zero(orthogonal_)) orthogonal_ = {1, 0, 0};
    } else if (picked_.size() == 2) {
      orthogonal_ = cross(vectors[picked_[0]], vectors[picked_[1]]);
    }
  }

  const std::vector<std::size_t>& picked() const { return picked_; }
  /// Nonzero, and orthogonal to all vectors when they do not span.
  const IntegerVector3& orthogonal() const { return orthogonal_; }

 private:
  std::vector<std::size_t> picked_;
  IntegerVector3 orthogonal_{0, 0, 1};
};

FreeMotion checked(const Problem& problem, const IntegerVector3& d) {
  const FreeMotion motion{twist_of(primitive(d))};
  require(!is_zero(d), "a free motion is zero");
  for (const ContactRow& row : problem.rows()) {
    require(power(row.normal, motion.twist).sign() >= 0, "a free motion penetrates a contact");
  }
  return motion;
}

FormClosure checked(const Problem& problem, FormClosure closure) {
  Wrench sum;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    require(closure.multipliers[i].sign() > 0, "a multiplier of form closure is not positive");
    sum += closure.multipliers[i] * problem.rows()[i].normal;
  }
  require(sum == Wrench{}, "the multipliers of form closure do not give zero");
  return closure;
}

}  // namespace

std::variant<FormClosure, FreeMotion> form_closure(const Problem& problem) {
  // sum (1 + x_i) N_i = 0, x >= 0: any positive multipliers are such, up to a common factor.
  LinearProgram program;
  program.add_variables(problem.size(), VariableKind::kNonNegative);
  std::vector<IntegerVector3> normals;
  for (const ContactRow& row : problem.rows()) {
    normals.push_back(primitive_multiple(coordinates(row.normal)));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    std::vector<Rational> coefficients;
    Rational sum = 0;
    for (const ContactRow& row : problem.rows()) {
      coefficients.push_back(coordinates(row.normal)[j]);
      sum += coefficients.back();
    }
    program.add_row(std::move(coefficients), Relation::kEqual, -sum);
  }
  const LpResult result = solve(program);
  if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
    const std::vector<Rational>& y = infeasible->farkas;
    return checked(problem, primitive_multiple<3>({-y[0], -y[1], -y[2]}));
  }
  const Span span(normals);
  if (span.picked().size() < 3) return checked(problem, span.orthogonal());
  std::vector<Rational> multipliers = std::get<Optimal>(result).point;
  for (Rational& multiplier : multipliers) multiplier += 1;
  return checked(problem, FormClosure{std::move(multipliers),
                                      {ContactId(span.picked()[0]), ContactId(span.picked()[1]),
                                       ContactId(span.picked()[2])}});
}

}  // namespace stickslip
