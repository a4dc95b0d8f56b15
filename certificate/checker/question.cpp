// SPDX-License-Identifier: MIT
#include "question.hpp"

#include <algorithm>

#include "answer.hpp"

namespace stickslip_check {
namespace {

[[noreturn]] void refuse(const std::string& part, const std::string& problem) {
  throw Malformed{"the question", part, problem};
}

/// w: that of the options, or of the case that they name, or the file's unless a direction asks
/// about others.
Vector wrench_asked(const Grasp& grasp, const Options& options) {
  if (options.wrench && options.case_name) {
    refuse("case", "a wrench is given as well; expected one of them");
  }
  if (options.wrench) return *options.wrench;
  if (options.case_name) {
    const auto found = grasp.cases.find(*options.case_name);
    if (found != grasp.cases.end()) return found->second;
    refuse("case", "the grasp has no case " + quote(*options.case_name));
  }
  if (options.direction) return Vector(kDimension);
  if (!grasp.cases.empty()) {
    refuse("case", "the grasp has " + std::to_string(grasp.cases.size()) +
                       " cases, and none is chosen; expected the name of one, such as " +
                       quote(grasp.cases.begin()->first));
  }
  return grasp.wrench;
}

bool below_zero(const Rational& x) {
  return x < 0;
}

/// N, T, and v_i(x) = P' h + P^u' l - k' N.d. Nothing if the length of the normal is irrational
/// and needed.
std::optional<Row> make_row(const Contact& contact, const Rational& preload,
                            const Rational& growth) {
  const Vector& p = contact.position;
  const Vector& n = contact.normal;
  const Vector t{Rational(-n[1]), n[0]};
  const Rational square = dot(n, n);
  std::optional<Rational> length = 1;
  if (preload != 0 || growth != 0) length = exact_sqrt(square);
  if (!length) return std::nullopt;
  Row row;
  row.normal = {n[0], n[1], Rational(p[0] * n[1] - p[1] * n[0])};
  row.tangent = {t[0], t[1], Rational(p[0] * t[1] - p[1] * t[0])};
  row.friction = contact.friction;
  for (const Rational& c : row.normal) row.v.emplace_back(-contact.stiffness / square * c);
  row.v.emplace_back(preload / *length);
  row.v.emplace_back(growth / *length);
  Rational v_scale;
  Rational edge_scale;
  row.v_form = make_form(row.v, &v_scale);
  row.slip_form = make_form(row.tangent);
  row.slip_form.resize(row.v.size());
  Vector edges;
  for (const int sigma : {-1, 1}) {
    for (std::size_t j = 0; j < kDimension; ++j) {
      edges.emplace_back(row.normal[j] + sigma * row.friction * row.tangent[j]);
    }
  }
  const Form both = make_form(edges, &edge_scale);
  row.edges[0].assign(both.begin(), both.begin() + kDimension);
  row.edges[1].assign(both.begin() + kDimension, both.end());
  row.weight = v_scale * edge_scale;
  return row;
}

}  // namespace

Question pose(const Grasp& grasp, const Options& options, const std::string& file) {
  const std::size_t m = grasp.contacts.size();
  Vector base;
  for (const Contact& contact : grasp.contacts) {
    base.push_back(options.preload.value_or(contact.preload));
  }
  if (options.preload && *options.preload < 0) {
    refuse("preload", "found " + show(*options.preload) + ", expected 0 or more");
  }
  Vector growth(m);
  if (options.preload_direction && options.preload_direction->scale) {
    std::swap(base, growth);
  } else if (options.preload_direction) {
    growth = options.preload_direction->values;
  }
  if (growth.size() != m || std::any_of(growth.begin(), growth.end(), below_zero)) {
    refuse("preload direction", "found " + show(growth) + ", expected " + std::to_string(m) +
                                    " numbers of 0 or more, one for each contact");
  }
  Question question;
  question.asked = options;
  question.growth = options.direction.value_or(Vector(kDimension));
  question.wrench = wrench_asked(grasp, options);
  if (options.margin() && question.growth == Vector(kDimension) && growth == Vector(m)) {
    refuse("direction",
           "neither the wrench nor a preload changes; expected a direction other "
           "than 0, or to scale preloads some of which are not 0");
  }
  for (std::size_t i = 0; i < m; ++i) {
    std::optional<Row> row = make_row(grasp.contacts[i], base[i], growth[i]);
    if (!row) {
      throw Malformed{
          file, "contacts[" + std::to_string(i) + "].normal",
          "the contact has a preload and a normal of irrational length, so there is "
          "no exact question; run stickslip snap GRASP -o FILE, and ask about FILE"};
    }
    question.rows.push_back(std::move(*row));
  }
  return question;
}

}  // namespace stickslip_check
