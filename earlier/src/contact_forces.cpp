// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_forces.hpp"

#include "stickslip/core/error.hpp"

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

RigidForces rigid_forces(const std::vector<ContactForce>& forces) {
  RigidForces result;
  for (const ContactForce& f : forces) result.push_back({f.normal, {f.tangential}});
  return result;
}

std::vector<ContactForce> planar_forces(const RigidForces& forces) {
  std::vector<ContactForce> result;
  for (const RigidForce& f : forces) result.push_back({f.normal, f.friction.at(0)});
  return result;
}

RationalRow row_of(const Twist& motion) {
  return {motion.x, motion.y, motion.r};
}

Twist planar_motion(const RationalRow& row) {
  return {row.at(0), row.at(1), row.at(2)};
}

void require_planar(const Inertia& inertia) {
  require(!inertia.in_space(), "the inertia is one of space");
  require(inertia.gyration.at(0).at(0).sign() > 0, "the radius of gyration must not be zero");
}

}  // namespace stickslip::earlier_detail
