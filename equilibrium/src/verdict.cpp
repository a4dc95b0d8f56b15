// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip {
namespace {

std::string at_contact(const char* condition, std::size_t contact) {
  return std::string(condition) + " fails at contact " + std::to_string(contact);
}

}  // namespace

std::optional<std::string> find_violation(const Problem& problem, const Witness& witness) {
  if (witness.forces.size() != problem.size()) return "one force per contact is needed";
  Wrench sum = problem.wrench();
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const auto& [a, b] = witness.forces[i];
    const Rational v = row.normal_coefficient(witness.twist);
    const bool opens = problem.law() == NormalLaw::kUnilateral && v.sign() < 0;
    if (a.sign() < 0 || a != (opens ? Rational(0) : v)) return at_contact("the normal law", i);
    const Rational limit = row.friction * a;
    if (b > limit || b < -limit) return at_contact("the friction cone", i);
    const int slip = power(row.tangent, witness.twist).sign();
    if ((slip > 0 && b != -limit) || (slip < 0 && b != limit)) {
      return at_contact("maximum dissipation", i);
    }
    sum += a * row.normal + b * row.tangent;
  }
  if (!(sum == Wrench{})) return "the balance of forces and torques fails";
  return std::nullopt;
}

const char* name_of(const Verdict& verdict) {
  if (std::holds_alternative<Stable>(verdict)) return "stable";
  if (std::holds_alternative<Unstable>(verdict)) return "unstable";
  return "undecided";
}

}  // namespace stickslip
