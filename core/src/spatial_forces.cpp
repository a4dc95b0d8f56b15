// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/spatial_forces.hpp"

#include "stickslip/core/error.hpp"

namespace stickslip {

Vector3 displacement(const Vector3& point, const Vector6& d) {
  Vector3 moved = cross({d[3], d[4], d[5]}, point);
  for (std::size_t j = 0; j < 3; ++j) moved[j] += d[j];
  return moved;
}

std::vector<SpatialForce> forces_of(const GraspBox& grasp, const Vector6& d,
                                    const std::vector<std::pair<ContactId, Vector3>>& shares) {
  std::vector<SpatialForce> forces(grasp.contacts.size());
  const auto root = [](const Rational& square) {
    const std::optional<Rational> length = exact_sqrt(square);
    require(length.has_value(), "forces_of: a length is irrational");
    return *length;
  };
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const UncertainContact& c = grasp.contacts[i];
    const Vector3 n = vector3(c.normal);
    const Rational square = dot(n, n);
    const Vector3 moved =
        displacement({c.position[0].low, c.position[1].low, c.position[2].low}, d);
    const Rational rise = dot(n, moved) / square;
    SpatialForce& force = forces[i];
    force.normal = -c.stiffness.low * rise;
    if (!c.preload.low.is_zero()) force.normal += c.preload.low / root(square);
    if (force.normal.sign() < 0) force.normal = 0;
    for (std::size_t j = 0; j < 3; ++j) force.slip[j] = moved[j] - rise * n[j];
    const Rational slip_square = dot(force.slip, force.slip);
    const Rational most = c.friction.low * force.normal;
    if (slip_square.is_zero() || most.is_zero()) continue;
    const Rational ratio = root(square / slip_square);
    for (std::size_t j = 0; j < 3; ++j) force.friction[j] = -most * ratio * force.slip[j];
  }
  for (const auto& [contact, share] : shares) {
    const std::size_t i = contact.index();
    const Rational most = grasp.contacts[i].friction.low * forces[i].normal;
    for (std::size_t j = 0; j < 3; ++j) forces[i].friction[j] = most * share[j];
  }
  for (std::size_t i = 0; i < forces.size(); ++i) {
    SpatialForce& force = forces[i];
    for (std::size_t j = 0; j < 3; ++j) {
      force.force[j] = force.normal * grasp.contacts[i].normal[j] + force.friction[j];
    }
  }
  return forces;
}

}  // namespace stickslip
