// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/verdict.hpp"

#include <array>
#include <utility>

#include "long_rationals.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

namespace {

std::string at_contact(const char* condition, std::size_t contact) {
  return std::string(condition) + " fails at contact " + std::to_string(contact);
}

/// Returns the motion, and the shares of friction of the contacts that stick and use some.
/// `contact_of(i)` returns contact i, with its friction; `tangent_of(c)` its tangent row.
template <class ContactOf, class TangentOf>
ShortWitness in_short(const Witness& witness, ContactOf contact_of, TangentOf tangent_of) {
  const ScaledTwist scaled(witness.twist);
  ShortWitness result{witness.twist, {}};
  for (std::size_t i = 0; i < witness.forces.size(); ++i) {
    const auto& [a, b] = witness.forces[i];
    if (b.is_zero()) continue;
    const auto& contact = contact_of(i);
    if (!power(tangent_of(contact), scaled.twist).is_zero()) continue;
    result.shares.emplace_back(ContactId(i), b / (contact.friction * a));
  }
  return result;
}

}  // namespace

ShortWitness in_short(const std::vector<ContactRow>& rows, const Witness& witness) {
  return in_short(
      witness, [&](std::size_t i) -> const ContactRow& { return rows[i]; },
      [](const ContactRow& row) -> const Wrench& { return row.tangent; });
}

ShortWitness in_short(const Grasp& grasp, const Witness& witness) {
  return in_short(
      witness, [&](std::size_t i) -> const Contact& { return grasp.contacts()[i]; },
      tangent_row);
}

std::optional<std::string> find_violation(const Problem& problem, const Witness& witness) {
  require(!problem.is_family(), "an equilibrium is of one member of a family");
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

const char* verdict_name(std::optional<bool> stable) {
  return !stable ? "undecided" : *stable ? "stable" : "unstable";
}

const char* name_of(const Verdict& verdict) {
  constexpr const char* kNames[] = {"stable", "unstable", "fragile", "undecided"};
  return kNames[verdict.index()];
}

std::optional<bool> is_stable(const Verdict& verdict) {
  if (std::holds_alternative<Stable>(verdict)) return true;
  if (std::holds_alternative<Unstable>(verdict)) return false;
  return std::nullopt;
}

std::string in_words(const Undecided& undecided) {
  return undecided.limit + (undecided.remedy.empty() ? "" : "; " + undecided.remedy);
}

}  // namespace stickslip
