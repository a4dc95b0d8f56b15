// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/degree/near_forces.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/degree/newton.hpp"
#include "stickslip/search/grasp_law.hpp"

namespace stickslip {

namespace {

Vector3 rationals(const Eigen::Vector3d& a) {
  return {rational_from_double(a[0]), rational_from_double(a[1]), rational_from_double(a[2])};
}

}  // namespace

std::vector<SpatialForce> near_forces(const Question& question, const RationalRow& d) {
  const GraspLaw law = law_of(question, kDefaultBits);
  const RoundedGrasp grasp = rounded_middle(law);
  NearEquilibrium near{Reals(6), {}, {}, {}};
  for (std::size_t j = 0; j < 6; ++j) {
    near.motion[static_cast<Eigen::Index>(j)] = to_double(d[j]) * law.unit(j);
  }
  std::vector<Eigen::Vector3d> slips;
  double furthest = 0;
  for (const RoundedContact& c : grasp.contacts) {
    slips.emplace_back(c.slip * near.motion);
    furthest = std::max(furthest, std::hypot(slips.back().norm(), c.normal.dot(near.motion)));
  }
  for (std::size_t i = 0; i < slips.size(); ++i) {
    const RoundedContact& c = grasp.contacts[i];
    constexpr double kNoSlip = 1e-6;
    const double a = c.force(near.motion);
    const bool still = slips[i].norm() <= kNoSlip * furthest;
    if (still) slips[i].setZero();
    const Eigen::Vector3d friction =
        still ? Eigen::Vector3d::Zero() : Eigen::Vector3d(-c.slope * a * slips[i].normalized());
    near.normal.push_back(a);
    near.friction.push_back({friction[0], friction[1], friction[2]});
    near.sticks.push_back(still && c.slope * a > 0 ? 1 : 0);
  }
  if (const auto polished = Newton(grasp).polish(near)) near = *polished;
  std::vector<SpatialForce> forces;
  for (std::size_t i = 0; i < slips.size(); ++i) {
    const double a = std::max(0.0, near.normal[i]);
    const Eigen::Vector3d friction(near.friction[i].data());
    const Eigen::Vector3d normal = a * grasp.contacts[i].normal.head<3>();
    forces.push_back({rational_from_double(a), rationals(slips[i]), rationals(friction),
                      rationals(normal + friction)});
  }
  return forces;
}

}  // namespace stickslip
