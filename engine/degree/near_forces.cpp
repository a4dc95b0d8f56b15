// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/near_forces.hpp"

#include <algorithm>
#include <cmath>

#include "newton.hpp"
#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {

namespace {

/// Returns a friction force, or a slip as one, as a vector. In the plane it is a multiple of
/// the normal turned by +90 degrees.
Vector3 as_vector(const RationalRow& f, const RationalRow& normal) {
  if (f.size() == 1) return {-f[0] * normal[1], f[0] * normal[0], 0};
  return {f[0], f[1], f[2]};
}

}  // namespace

std::vector<SpatialForce> near_forces(const Question& question, const RationalRow& d) {
  const GraspLaw law = law_of(question, kDefaultBits);
  const RoundedGrasp grasp = rounded_middle(law);
  NearEquilibrium near{Reals(grasp.motions()), {}, {}, {}};
  for (std::size_t j = 0; j < d.size(); ++j) {
    near.motion[static_cast<Eigen::Index>(j)] = to_double(d[j]) * law.unit(j);
  }
  std::vector<Double3> slips;  // slips in the form of near.friction
  double furthest = 0;
  for (const RoundedContact& c : grasp.contacts) {
    const Eigen::VectorXd slip = c.slip * near.motion;
    std::copy(slip.begin(), slip.end(), slips.emplace_back().begin());
    furthest = std::max(furthest, std::hypot(slip.norm(), c.normal.dot(near.motion)));
  }
  for (std::size_t i = 0; i < slips.size(); ++i) {
    const RoundedContact& c = grasp.contacts[i];
    constexpr double kNoSlip = 1e-6;
    const double a = c.force(near.motion);
    const double size = norm_of(slips[i]);
    const bool still = size <= kNoSlip * furthest;
    if (still) slips[i] = {};
    Double3& friction = near.friction.emplace_back(slips[i]);
    for (double& f : friction) f *= still ? 0 : -c.slope * a / size;
    near.normal.push_back(a);
    near.sticks.push_back(still && c.slope * a > 0 ? 1 : 0);
  }
  if (const auto polished = Newton(grasp).polish(near)) near = *polished;
  std::vector<SpatialForce> forces;
  const std::vector<UncertainContact>& contacts = question.box()->contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    constexpr int kBits = 60;
    const LawContact& c = law.contacts[i];
    const RationalRow& n = contacts[i].normal;
    const RationalRow slip = c.force_near(slips[i], kBits);
    const RationalRow friction = c.force_near(near.friction[i], kBits);
    SpatialForce& f = forces.emplace_back();
    f.normal = rational_from_double(std::max(0.0, near.normal[i]));
    f.slip = as_vector(slip, n);
    f.friction = as_vector(friction, n);
    for (std::size_t j = 0; j < n.size(); ++j) f.force[j] = f.normal * n[j];
    for (std::size_t j = 0; j < 3; ++j) f.force[j] += f.friction[j];
    if (slip.size() < 4) continue;
    f.spin = slip[3] / c.spin_weight;
    f.moment = friction[3];
  }
  return forces;
}

}  // namespace stickslip
