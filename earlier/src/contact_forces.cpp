// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_forces.hpp"

namespace stickslip::earlier_detail {

Wrench resultant(const Problem& problem, const std::vector<ContactForce>& forces) {
  Wrench sum = problem.wrench();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    sum += forces[i].normal * row.normal + forces[i].tangential * row.tangent;
  }
  return sum;
}

bool is_in_cone(const ContactRow& row, const ContactForce& force) {
  return force.normal.sign() >= 0 && abs(force.tangential) <= row.friction * force.normal;
}

bool balances_in_cones(const Problem& problem, const std::vector<ContactForce>& forces) {
  if (forces.size() != problem.size()) return false;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!is_in_cone(problem.rows()[i], forces[i])) return false;
  }
  return resultant(problem, forces) == Wrench{};
}

ContactForce force_of_edges(const ContactRow& row, const Rational& plus,
                            const Rational& minus) {
  return {plus + minus, row.friction * (plus - minus)};
}

}  // namespace stickslip::earlier_detail
