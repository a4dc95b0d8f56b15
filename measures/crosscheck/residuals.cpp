// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "solution.hpp"
#include "stickslip/measures/claim.hpp"

namespace stickslip {

using namespace crosscheck_detail;

namespace {

void raise(LargestResidual& largest, RootSum value, std::size_t contact) {
  if (largest.value < value) largest = {std::move(value), ContactId(contact)};
}

}  // namespace

ResidualScale residual_scale(const GraspBox& grasp, const Claim& claim) {
  ResidualScale scale;
  scale.length = largest_coordinate(grasp);
  scale.force = size_of(components(grasp.wrench), scale.length);
  if (claim.forces) {
    for (const RationalRow& f : *claim.forces) scale.force = std::max(scale.force, largest(f));
  }
  Rational stiffest = grasp.contacts.empty() ? Rational(1) : Rational(0);
  for (const UncertainContact& c : grasp.contacts) {
    scale.force = std::max(scale.force, c.preload.low);
    stiffest = std::max(stiffest, c.stiffness.low);
  }
  if (scale.force.is_zero()) scale.force = 1;
  scale.motion = scale.force / stiffest;
  if (const auto& d = claim.twist) {
    // Rotations count times the length, as torques count over it.
    scale.motion = std::max(scale.motion, size_of(*d, 1 / scale.length));
  }
  return scale;
}

const char* name_of(ResidualCondition condition) {
  constexpr const char* kNames[] = {"balance", "cone", "normal law", "dissipation"};
  return kNames[static_cast<std::size_t>(condition)];
}

std::vector<ResidualCondition> ClaimResiduals::missed(const Rational& tolerance,
                                                      const ResidualScale& scale) const {
  std::vector<ResidualCondition> conditions;
  const Rational force = tolerance * scale.force;
  if (balance && size_of(*balance, scale.length) > force) {
    conditions.push_back(ResidualCondition::kBalance);
  }
  const auto compare = [&](const std::optional<LargestResidual>& residual, const Rational& most,
                           ResidualCondition condition) {
    if (residual && RootSum(most) < residual->value) conditions.push_back(condition);
  };
  compare(cone, force, ResidualCondition::kCone);
  compare(normal_law, force, ResidualCondition::kNormalLaw);
  compare(dissipation, force * scale.motion, ResidualCondition::kDissipation);
  return conditions;
}

ClaimResiduals residuals_of(const GraspBox& grasp, NormalLaw law, const Claim& claim) {
  ClaimResiduals result;
  if (!claim.forces) return result;
  result.balance = components(grasp.wrench);
  result.cone.emplace();
  if (claim.twist) {
    result.normal_law.emplace();
    result.dissipation.emplace();
  }
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const RationalRow& force = (*claim.forces)[i];
    const Rational& friction = grasp.contacts[i].friction.low;
    const ContactGeometry contact(grasp.contacts[i]);
    result.balance = sum(std::move(*result.balance), 1, contact.wrench_of(force));
    const Rational a = contact.along(force);
    const RootSum normal = RootSum::root(a, contact.square());
    const RationalRow tangential = contact.across(force);
    raise(*result.cone,
          RootSum::root(1, dot(tangential, tangential)) -
              RootSum::root(friction * a, contact.square()),
          i);
    raise(*result.cone, -normal, i);
    if (!claim.twist) continue;
    const RationalRow moved = contact.displacement(*claim.twist);
    RootSum of_motion = contact.separation(moved);
    if (law == NormalLaw::kUnilateral && of_motion.sign() < 0) of_motion = RootSum();
    raise(*result.normal_law, magnitude(normal - of_motion), i);
    const RationalRow slip = contact.across(moved);
    raise(*result.dissipation,
          magnitude(RootSum::root(friction * a, contact.square() * dot(slip, slip)) +
                    dot(tangential, slip)),
          i);
  }
  return result;
}

}  // namespace stickslip
