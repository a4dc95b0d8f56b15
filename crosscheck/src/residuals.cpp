// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "stickslip/crosscheck/claim.hpp"

namespace stickslip {
namespace {

void raise(LargestResidual& largest, Magnitude value, std::size_t contact) {
  if (largest.value < value) largest = {std::move(value), ContactId(contact)};
}

}  // namespace

Magnitude Magnitude::of(const Rational& coefficient, const Rational& length_squared) {
  const Rational size = abs(coefficient);
  if (size.is_zero()) return {0, 1};
  if (const auto length = exact_sqrt(length_squared)) return {size * *length, 1};
  return {size, length_squared};
}

bool Magnitude::operator<(const Magnitude& other) const {
  return coefficient * coefficient * radicand <
         other.coefficient * other.coefficient * other.radicand;
}

Rational largest_coordinate(const Grasp& grasp) {
  Rational largest = 0;
  for (const Contact& c : grasp.contacts()) {
    largest = std::max<Rational>({largest, abs(c.position.x), abs(c.position.y)});
  }
  return largest.is_zero() ? Rational(1) : largest;
}

ResidualScale residual_scale(const LoadedGrasp& loaded, const ApproximateEquilibrium& claimed) {
  const std::vector<Contact>& contacts = loaded.grasp.contacts();
  const Wrench& w = loaded.wrench;
  ResidualScale scale;
  scale.length = largest_coordinate(loaded.grasp);
  scale.force = std::max<Rational>({abs(w.x), abs(w.y), abs(w.torque) / scale.length});
  Rational stiffest = 1;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = contacts[i];
    scale.force = std::max(scale.force, c.preload);
    stiffest = i == 0 ? c.stiffness : std::max(stiffest, c.stiffness);
    if (!claimed.forces) continue;
    const Vector2 force = force_vector(c.normal, (*claimed.forces)[i]);
    scale.force = std::max<Rational>({scale.force, abs(force.x), abs(force.y)});
  }
  if (scale.force.is_zero()) scale.force = 1;
  scale.motion = scale.force / stiffest;
  if (const auto& d = claimed.twist) {
    scale.motion =
        std::max<Rational>({scale.motion, abs(d->x), abs(d->y), abs(d->r) * scale.length});
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
  if (balance && (abs(balance->x) > force || abs(balance->y) > force ||
                  abs(balance->torque) > force * scale.length)) {
    conditions.push_back(ResidualCondition::kBalance);
  }
  const auto compare = [&](const std::optional<LargestResidual>& residual, const Rational& most,
                           ResidualCondition condition) {
    if (residual && Magnitude{most, 1} < residual->value) conditions.push_back(condition);
  };
  compare(cone, force, ResidualCondition::kCone);
  compare(normal_law, force, ResidualCondition::kNormalLaw);
  compare(dissipation, force * scale.motion, ResidualCondition::kDissipation);
  return conditions;
}

ClaimResiduals residuals_of(const Problem& problem, const ApproximateEquilibrium& claimed) {
  ClaimResiduals result;
  if (!claimed.forces) return result;
  result.balance = problem.wrench();
  result.cone.emplace();
  if (claimed.twist) {
    result.normal_law.emplace();
    result.dissipation.emplace();
  }
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const auto& [a, b] = (*claimed.forces)[i];
    const Rational length_squared = row.normal.x * row.normal.x + row.normal.y * row.normal.y;
    *result.balance += a * row.normal + b * row.tangent;
    const Rational outside = std::max<Rational>({0, abs(b) - row.friction * a, -a});
    raise(*result.cone, Magnitude::of(outside, length_squared), i);
    if (!claimed.twist) continue;
    Rational v = row.normal_coefficient(*claimed.twist);
    if (problem.law() == NormalLaw::kUnilateral && v.sign() < 0) v = 0;
    raise(*result.normal_law, Magnitude::of(a - v, length_squared), i);
    const Rational slip = power(row.tangent, *claimed.twist);
    raise(*result.dissipation, {abs(row.friction * a * abs(slip) + b * slip), 1}, i);
  }
  return result;
}

}  // namespace stickslip
