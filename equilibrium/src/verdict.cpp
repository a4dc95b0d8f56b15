// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/verdict.hpp"

#include <array>
#include <utility>

#include "long_rationals.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/search/region.hpp"

namespace stickslip {

using namespace equilibrium_detail;

namespace {

std::string at_contact(const char* condition, std::size_t contact) {
  return std::string(condition) + " fails at contact " + std::to_string(contact);
}

/// By what is known of a contact, with its friction, and the T of that.
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

const char* name_of(const Verdict& verdict) {
  if (std::holds_alternative<Stable>(verdict)) return "stable";
  if (std::holds_alternative<Unstable>(verdict)) return "unstable";
  return "undecided";
}

std::string in_words(const Undecided& undecided) {
  return undecided.limit + (undecided.remedy.empty() ? "" : "; " + undecided.remedy);
}

namespace {

/// Pushes a node's children, the first one last; or says what is wrong with the node.
struct NodeCheck {
  const Problem& problem;
  const Region& region;
  std::vector<Region>& pending;

  std::optional<std::string> operator()(const SlipSplit& node) const {
    if (node.contact.index() >= problem.size()) return "no such contact";
    if (region.label(node.contact)) return "a second slip split of one contact";
    for (const Sign slip : {Sign::kNegative, Sign::kZero, Sign::kPositive}) {
      pending.push_back(region.slip_child(problem, node.contact, slip));
    }
    return std::nullopt;
  }
  std::optional<std::string> operator()(const SeparationSplit& node) const {
    if (node.contact.index() >= problem.size()) return "no such contact";
    if (problem.law() == NormalLaw::kBilateral) return "a separation under the bilateral law";
    for (const Separation side : {Separation::kOpen, Separation::kClosed}) {
      pending.push_back(region.separation_child(problem, node.contact, side));
    }
    return std::nullopt;
  }
  std::optional<std::string> operator()(const PlaneSplit& node) const {
    if (is_zero(node.plane)) return "a plane without a normal";
    pending.push_back(region.plane_child(node.plane, Side::kNegative));
    pending.push_back(region.plane_child(node.plane, Side::kPositive));
    return std::nullopt;
  }
  std::optional<std::string> operator()(const VirtualWorkLeaf& node) const {
    if (!refutes(problem, region, node)) return "the twist does not refute the region";
    return std::nullopt;
  }
};

}  // namespace

std::optional<std::string> find_flaw(const Problem& problem, const Refutation& refutation) {
  std::vector<Region> pending{Region::root(problem)};
  for (std::size_t index = 0; index < refutation.size(); ++index) {
    const std::string place = "node " + std::to_string(index) + ": ";
    if (pending.empty()) return place + "the tree is complete before it";
    const Region region = std::move(pending.back());
    pending.pop_back();
    const auto flaw = std::visit(NodeCheck{problem, region, pending}, refutation[index]);
    if (flaw) return place + *flaw;
  }
  if (!pending.empty()) return "the tree ends before all children are there";
  return std::nullopt;
}

void validate(const Problem& problem, const Verdict& verdict) {
  std::optional<std::string> flaw;
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    flaw = find_violation(problem, stable->witness);
  } else if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
    flaw = find_flaw(problem, unstable->refutation);
  }
  require(!flaw, flaw ? flaw->c_str() : "");
}

}  // namespace stickslip
