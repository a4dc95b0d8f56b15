// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison_text.hpp"

#include "stickslip/equilibrium/decide.hpp"

namespace stickslip {

std::string contact_name(std::size_t index) {
  return "contact " + std::to_string(index);
}

std::string cases_refuted(std::size_t count) {
  return "(" + std::to_string(count) + (count == 1 ? " case refuted)" : " cases refuted)");
}

Vector2 vector_of(const ContactRow& row, const ContactForce& f) {
  return force_vector({row.normal.x, row.normal.y}, f);
}

Json forces_json(const Problem& problem, const std::vector<ContactForce>& forces) {
  Json json = Json::array();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    json.push_back(number_json(vector_of(problem.rows()[i], forces[i])));
  }
  return json;
}

Json witness_json(const Problem& problem, const Witness& witness) {
  return {{"twist", number_json(coordinates(witness.twist))},
          {"forces", forces_json(problem, witness.forces)}};
}

Json motion_json(const Twist& d) {
  return {{"motion", number_json(coordinates(d))}};
}

Json refutation_json(const Refutation& refutation) {
  const RefutationSummary summary = summarize(refutation);
  return {{"refutation", {{"nodes", summary.nodes}, {"leaves", summary.leaves}}}};
}

std::string some_forces(const Problem& problem, const std::vector<ContactForce>& forces,
                        NumberText& text) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const Vector2 f = vector_of(problem.rows()[i], forces[i]);
    if (f == Vector2{}) continue;
    parts.push_back(text(f) + " at " + contact_name(i));
  }
  if (parts.empty()) return "no forces at all";
  if (parts.size() == 1) return "the force " + parts[0];
  if (parts.size() == 2) return "the forces " + parts[0] + " and " + parts[1];
  return "the forces " + parts[0] + ", " + parts[1] + " and " +
         std::to_string(parts.size() - 2) + " more";
}

std::string dissipation_breach(const Problem& problem, const Witness& witness,
                               NumberText& text) {
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactForce& f = witness.forces[i];
    const Rational slip = power(row.tangent, witness.twist);
    if (slip.is_zero() || f.normal.is_zero()) continue;
    const Rational against = Rational(-slip.sign()) * f.tangential / f.normal;
    if (against == row.friction) continue;
    const std::string slips = "lets " + contact_name(i) + " slip ";
    const std::string mu = "mu = " + text(row.friction);
    if (against.is_zero()) return slips + "without friction, though " + mu;
    if (against.sign() > 0) {
      return slips + "against friction of only " + text(against) +
             " of the normal force, not " + mu;
    }
    return slips + "with friction pushing along, by " + text(Rational(-against)) +
           " of the normal force";
  }
  return "";
}

}  // namespace stickslip
