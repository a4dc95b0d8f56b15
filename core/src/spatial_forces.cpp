// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/spatial_forces.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// Returns a vector of the plane, or of space, as one in space.
Vector3 in_three(const RationalRow& a) {
  return {a[0], a[1], a.size() == 3 ? a[2] : Rational(0)};
}

/// Returns, as in space, the twist of the body that is pressed beside the other one. `d` is the
/// motion of the one body, or a state.
RationalRow relative_twist(const GraspBox& grasp, const UncertainContact& c,
                           const RationalRow& d) {
  RationalRow twist = d;
  if (grasp.mechanism) {
    twist.clear();
    for (const RationalRow& row : grasp.mechanism->motion_between(c.of, c.by)) {
      twist.push_back(dot(row, d));
    }
  }
  if (twist.size() == 3) return {twist[0], twist[1], 0, 0, 0, twist[2]};
  return twist;
}

}  // namespace

Vector3 displacement(const Vector3& point, const RationalRow& d) {
  Vector3 moved = cross({d[3], d[4], d[5]}, point);
  for (std::size_t j = 0; j < 3; ++j) moved[j] += d[j];
  return moved;
}

std::vector<SpatialForce> forces_of(
    const GraspBox& grasp, const RationalRow& d,
    const std::vector<std::pair<ContactId, RationalRow>>& shares) {
  std::vector<SpatialForce> forces(grasp.contacts.size());
  // Sums of long numbers are made of integers: d is `unit` times those.
  const Row x = primitive_multiple(d);
  const auto some =
      std::find_if(x.begin(), x.end(), [](const Integer& entry) { return !entry.is_zero(); });
  const Rational unit = some == x.end()
                            ? Rational(1)
                            : d[static_cast<std::size_t>(some - x.begin())] / Rational(*some);
  const RationalRow whole(x.begin(), x.end());
  const auto root = [](const Rational& square) {
    const std::optional<Rational> length = exact_sqrt(square);
    require(length.has_value(), "forces_of: a length is irrational");
    return *length;
  };
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const UncertainContact& c = grasp.contacts[i];
    const Vector3 n = in_three(c.normal);
    const Rational square = dot(n, n);
    const Rational weight = c.torsion * c.torsion / square;  // the weight of a spin in |s|^2
    RationalRow position;
    for (const Interval& coordinate : c.position) position.push_back(coordinate.low);
    const RationalRow twist = relative_twist(grasp, c, whole);
    const Vector3 moved = displacement(in_three(position), twist);
    const Rational rise = dot(n, moved) / square;
    SpatialForce& force = forces[i];
    force.normal = -c.stiffness.low * rise * unit;
    if (!c.preload.low.is_zero()) force.normal += c.preload.low / root(square);
    if (force.normal.sign() < 0) force.normal = 0;
    Vector3 slip;
    Rational spin = 0;
    for (std::size_t j = 0; j < 3; ++j) slip[j] = moved[j] - rise * n[j];
    if (!weight.is_zero()) spin = n[0] * twist[3] + n[1] * twist[4] + n[2] * twist[5];
    for (std::size_t j = 0; j < 3; ++j) force.slip[j] = slip[j] * unit;
    force.spin = spin * unit;
    const Rational slip_square = dot(slip, slip) + weight * spin * spin;
    const Rational most = c.friction.low * force.normal;
    if (slip_square.is_zero() || most.is_zero()) continue;
    const Rational ratio = root(square / slip_square);
    for (std::size_t j = 0; j < 3; ++j) force.friction[j] = -most * ratio * slip[j];
    force.moment = -most * ratio * weight * spin;
  }
  for (const auto& [contact, share] : shares) {
    const std::size_t i = contact.index();
    const Rational most = grasp.contacts[i].friction.low * forces[i].normal;
    const RationalRow& n = grasp.contacts[i].normal;
    // A share in the plane is a multiple of the normal turned by +90 degrees.
    const Vector3 along = share.size() == 1 ? Vector3{-share[0] * n[1], share[0] * n[0], 0}
                                            : Vector3{share[0], share[1], share[2]};
    if (share.size() == 4) forces[i].moment = most * share[3];
    for (std::size_t j = 0; j < 3; ++j) forces[i].friction[j] = most * along[j];
  }
  for (std::size_t i = 0; i < forces.size(); ++i) {
    SpatialForce& force = forces[i];
    const Vector3 n = in_three(grasp.contacts[i].normal);
    for (std::size_t j = 0; j < 3; ++j) {
      force.force[j] = force.normal * n[j] + force.friction[j];
    }
  }
  return forces;
}

bool has_torsion(const GraspBox& grasp) {
  return std::any_of(grasp.contacts.begin(), grasp.contacts.end(),
                     [](const UncertainContact& c) { return !c.torsion.is_zero(); });
}

RationalRow moment_of(const SpatialForce& force, const UncertainContact& contact) {
  RationalRow moment = contact.normal;
  for (Rational& entry : moment) entry *= force.moment;
  return moment;
}

RationalRow vector_in(const GraspBox& grasp, const Vector3& v) {
  return {v.begin(), v.begin() + (grasp.in_space() ? 3 : 2)};
}

std::vector<Rational> spring_forces_of(const GraspBox& grasp, const RationalRow& z) {
  std::vector<Rational> forces;
  for (const Spring& spring : grasp.springs) {
    Rational force = spring.force.low - spring.stiffness.low * dot(spring.row, z);
    if (spring.is_ratchet() && force.sign() < 0) force = 0;
    forces.push_back(std::move(force));
  }
  return forces;
}

}  // namespace stickslip
