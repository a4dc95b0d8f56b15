// SPDX-License-Identifier: GPL-3.0-or-later
#include "earlier/robustness/force_model.hpp"

#include <algorithm>
#include <cmath>

#include "earlier/src/friction_disc.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::robustness_detail {
namespace {

constexpr unsigned kConeRootBits = 64;

/// Returns two unit vectors that are orthogonal to a unit vector n and to each other: the
/// reflection that takes an axis to n takes the other two there.
std::vector<RationalRow> tangents_of(const RationalRow& n) {
  // The axis is the one that n is farthest from, so that the mirror is not short.
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 3; ++j) {
    if (n[j] < n[axis]) axis = j;
  }
  RationalRow mirror = n;
  mirror[axis] -= 1;
  const Rational square = dot(mirror, mirror);
  std::vector<RationalRow> result;
  for (std::size_t other = 1; other < 3; ++other) {
    const std::size_t j = (axis + other) % 3;
    RationalRow t(3);
    t[j] = 1;
    const Rational factor = -2 * mirror[j] / square;
    for (std::size_t k = 0; k < 3; ++k) t[k] += factor * mirror[k];
    result.push_back(std::move(t));
  }
  return result;
}

/// Returns the wrench of a force at a point, with its torque over the length.
RationalRow scaled_wrench(const RationalRow& point, const RationalRow& force,
                          const Rational& length) {
  RationalRow result = wrench_at(point, force);
  for (std::size_t j = point.size(); j < result.size(); ++j) result[j] /= length;
  return result;
}

ForceContact contact_of(const UncertainContact& contact, std::size_t index,
                        const RobustnessOptions& options) {
  const Rational norm = earlier_detail::rational_length(contact, index);
  RationalRow n = contact.normal;
  for (Rational& x : n) x /= norm;
  const std::vector<RationalRow> t =
      n.size() == 2 ? std::vector<RationalRow>{{-n[1], n[0]}} : tangents_of(n);
  const RationalRow point = contact.point();
  const Rational& mu = contact.friction.low;
  std::vector<ScaledRow> tangents;
  for (const RationalRow& along : t) {
    tangents.emplace_back(scaled_wrench(point, along, options.length));
  }
  ForceContact result{ScaledRow(scaled_wrench(point, n, options.length)),
                      std::move(tangents),
                      std::move(n),
                      t,
                      mu,
                      short_sqrt(1 + mu * mu, kConeRootBits),
                      contact.stiffness.low,
                      0};
  result.normal_double = doubles_of(result.normal.row());
  for (std::size_t k = 0; k < t.size(); ++k) {
    result.tangents_double[k] = doubles_of(result.tangents[k].row());
  }
  result.friction_double = to_double(mu);
  result.root_double = to_double(result.root.upper);
  result.stiffness_double = to_double(result.stiffness);
  return result;
}

}  // namespace

ScaledRow::ScaledRow(const RationalRow& row) : integers(primitive_multiple(row)), factor(1) {
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (!row[j].is_zero()) factor = row[j] / Rational(integers[j]);
  }
}

RationalRow ScaledRow::row() const {
  RationalRow result;
  for (const Integer& x : integers) result.push_back(factor * Rational(x));
  return result;
}

Doubles doubles_of(const RationalRow& row) {
  Doubles result{};
  for (std::size_t j = 0; j < row.size(); ++j) result[j] = to_double(row[j]);
  return result;
}

FrictionDirection direction_at(double angle) {
  // Rational points of the circle are ((1 - x^2) / (1 + x^2), 2 x / (1 + x^2)), here for |x| <=
  // 1/2, turned by right angles.
  constexpr double kRight = 1.5707963267948966;
  const double turns = std::round(angle / kRight);
  const Rational x = rational_in_bits(
      std::round(std::tan((angle - turns * kRight) / 2) * 0x1p16) / 0x1p16, 20);
  const Rational square = x * x;
  Rational c = (1 - square) / (1 + square);
  Rational s = 2 * x / (1 + square);
  for (int quarter = (static_cast<int>(turns) % 4 + 4) % 4; quarter > 0; --quarter) {
    std::swap(c, s);
    c.negate();
  }
  return {{c, s}};
}

std::vector<FrictionDirection> corners_of_polygon(std::size_t count) {
  std::vector<FrictionDirection> result;
  constexpr double kTurn = 6.283185307179586;
  for (std::size_t k = 0; k < count; ++k) {
    result.push_back(direction_at(kTurn * static_cast<double>(k) / static_cast<double>(count)));
  }
  return result;
}

ForceModel::ForceModel(const GraspBox& grasp, const RobustnessOptions& options)
    : coordinates(grasp.in_space() ? 6 : 3) {
  require(options.length.sign() > 0, "the characteristic length must be above 0");
  const std::vector<Rational>& forces_allowed = options.most_forces;
  require(forces_allowed.size() == 1 || forces_allowed.size() == grasp.contacts.size(),
          "give one largest force, or one for each contact");
  require(options.accuracy.sign() > 0, "the accuracy must be above 0");
  require(options.edges == 0 || (options.edges >= 3 && grasp.in_space()),
          "a pyramid has three edges or more, and is in space");
  require(grasp.is_point() && !grasp.mechanism, "these measures are of one grasp of one body");
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    contacts.push_back(contact_of(grasp.contacts[i], i, options));
    const Rational& f = forces_allowed[forces_allowed.size() == 1 ? 0 : i];
    require(f.sign() > 0, "the largest force must be above 0");
    contacts[i].most_force = f;
    contacts[i].most_force_double = to_double(f);
    if (options.edges > 0) contacts[i].edges = corners_of_polygon(options.edges);
    most_force = std::max(most_force, f);
    is_uniform = is_uniform && contacts[i].stiffness == contacts[0].stiffness;
  }
  const std::size_t forces = grasp.in_space() ? 3 : 2;
  for (std::size_t j = 0; j < coordinates; ++j) {
    const Rational& w = grasp.wrench[j].low;
    load.push_back(j < forces ? w : Rational(w / options.length));
  }
  load_double = doubles_of(load);
  most_force_double = to_double(most_force);
}

std::vector<RationalRow> ForceModel::columns(const std::vector<SpringState>& states) const {
  std::vector<RationalRow> result;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (states[i] == SpringState::kDetached) continue;
    result.push_back(contacts[i].normal.row());
    if (states[i] == SpringState::kSlip) continue;
    for (const ScaledRow& t : contacts[i].tangents) result.push_back(t.row());
  }
  return result;
}

}  // namespace stickslip::robustness_detail
