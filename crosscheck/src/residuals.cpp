// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "stickslip/crosscheck/claim.hpp"

namespace stickslip {
namespace {

void raise(LargestResidual& largest, Magnitude value, std::size_t contact) {
  if (largest.value < value) largest = {std::move(value), ContactId(contact)};
}

bool is_within(const std::optional<LargestResidual>& residual, const Magnitude& tolerance) {
  return !residual || !(tolerance < residual->value);
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

bool ClaimResiduals::within(const Rational& tolerance) const {
  if (balance) {
    for (const Rational& component : coordinates(*balance)) {
      if (abs(component) > tolerance) return false;
    }
  }
  const Magnitude limit{tolerance, 1};
  return is_within(cone, limit) && is_within(normal_law, limit) &&
         is_within(dissipation, limit);
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
