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

/// The normal of a contact in the middle of the question's box, and across it: what a row of
/// its slip is about, in space along the axes.
struct Directions {
  Eigen::Vector3d normal{0, 0, 0};
  Eigen::Matrix3d across = Eigen::Matrix3d::Identity();

  explicit Directions(const RationalRow& n) {
    for (std::size_t j = 0; j < n.size(); ++j) {
      normal[static_cast<Eigen::Index>(j)] = to_double(n[j]);
    }
    if (n.size() == 2) across.col(0) << -normal[1], normal[0], 0;
  }
};

}  // namespace

std::vector<SpatialForce> near_forces(const Question& question, const RationalRow& d) {
  const GraspLaw law = law_of(question, kDefaultBits);
  const RoundedGrasp grasp = rounded_middle(law);
  NearEquilibrium near{Reals(grasp.motions()), {}, {}, {}};
  for (std::size_t j = 0; j < d.size(); ++j) {
    near.motion[static_cast<Eigen::Index>(j)] = to_double(d[j]) * law.unit(j);
  }
  std::vector<Eigen::VectorXd> slips;
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
    Double3& friction = near.friction.emplace_back();
    for (Eigen::Index k = 0; k < slips[i].size() && !still; ++k) {
      friction[static_cast<std::size_t>(k)] = -c.slope * a * slips[i].normalized()[k];
    }
    near.normal.push_back(a);
    near.sticks.push_back(still && c.slope * a > 0 ? 1 : 0);
  }
  if (const auto polished = Newton(grasp).polish(near)) near = *polished;
  std::vector<SpatialForce> forces;
  const std::vector<UncertainContact>& contacts = question.box()->contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Directions at(contacts[i].normal);
    const double a = std::max(0.0, near.normal[i]);
    const Eigen::Index rows = slips[i].size();
    const Eigen::Vector3d slip = at.across.leftCols(rows) * slips[i];
    const Eigen::Vector3d friction =
        at.across.leftCols(rows) * Eigen::Vector3d(near.friction[i].data()).head(rows);
    forces.push_back({rational_from_double(a), rationals(slip), rationals(friction),
                      rationals(a * at.normal + friction)});
  }
  return forces;
}

}  // namespace stickslip
