// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/verdict.hpp"

#include <array>

#include "scaled_twist.hpp"

namespace stickslip {
namespace {

std::string at_contact(const char* condition, std::size_t contact) {
  return std::string(condition) + " fails at contact " + std::to_string(contact);
}

}  // namespace

/// The sum of rationals in pairs, so that long numbers meet only at the end.
Rational sum_in_pairs(std::vector<Rational> terms) {
  if (terms.empty()) return 0;
  while (terms.size() > 1) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k + 1 < terms.size(); k += 2)
      terms[kept++] = terms[k] + terms[k + 1];
    if (terms.size() % 2 == 1) terms[kept++] = std::move(terms.back());
    terms.resize(kept);
  }
  return std::move(terms.front());
}

ScaledTwist::ScaledTwist(const Twist& d) {
  Integer common = 1;
  for (const Rational& entry : coordinates(d)) common = lcm(common, denominator(entry));
  scale = common;
  twist = {scale * d.x, scale * d.y, scale * d.r};
}

std::optional<std::string> find_violation(const Problem& problem, const Witness& witness) {
  if (witness.forces.size() != problem.size()) return "one force per contact is needed";
  const ScaledTwist scaled(witness.twist);
  const Rational& q = scaled.scale;
  std::array<std::vector<Rational>, 3> balance;
  for (std::size_t j = 0; j < 3; ++j) balance[j] = {q * coordinates(problem.wrench())[j]};
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const Rational v = scaled.normal_coefficient(row);
    const Rational a = q * witness.forces[i].normal;
    const Rational b = q * witness.forces[i].tangential;
    const bool opens = problem.law() == NormalLaw::kUnilateral && v.sign() < 0;
    if (a.sign() < 0 || a != (opens ? Rational(0) : v)) return at_contact("the normal law", i);
    const Rational limit = row.friction * a;
    if (b > limit || b < -limit) return at_contact("the friction cone", i);
    const int slip = power(row.tangent, scaled.twist).sign();
    if ((slip > 0 && b != -limit) || (slip < 0 && b != limit)) {
      return at_contact("maximum dissipation", i);
    }
    const Vector3 wrench = coordinates(a * row.normal + b * row.tangent);
    for (std::size_t j = 0; j < 3; ++j) balance[j].push_back(wrench[j]);
  }
  for (std::vector<Rational>& terms : balance) {
    if (!sum_in_pairs(std::move(terms)).is_zero()) {
      return "the balance of forces and torques fails";
    }
  }
  return std::nullopt;
}

Vector2 force_vector(const Vector2& normal, const ContactForce& force) {
  return {force.normal * normal.x - force.tangential * normal.y,
          force.normal * normal.y + force.tangential * normal.x};
}

const char* name_of(const Verdict& verdict) {
  if (std::holds_alternative<Stable>(verdict)) return "stable";
  if (std::holds_alternative<Unstable>(verdict)) return "unstable";
  return "undecided";
}

}  // namespace stickslip
