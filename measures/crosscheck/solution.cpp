// SPDX-License-Identifier: GPL-3.0-or-later
#include "solution.hpp"

#include <algorithm>

#include "stickslip/core/spatial_forces.hpp"

namespace stickslip::crosscheck_detail {

RationalRow sum(RationalRow a, const Rational& factor, const RationalRow& b) {
  for (std::size_t j = 0; j < a.size(); ++j) a[j] += factor * b[j];
  return a;
}

Rational largest(const RationalRow& row) {
  Rational result = 0;
  for (const Rational& entry : row) result = std::max(result, Rational(abs(entry)));
  return result;
}

Rational largest_coordinate(const GraspBox& grasp) {
  Rational result = 0;
  for (const UncertainContact& c : grasp.contacts) {
    for (const Interval& x : c.position) result = std::max(result, Rational(abs(x.low)));
  }
  return result.is_zero() ? Rational(1) : result;
}

RationalRow components(const WrenchBox& wrench) {
  RationalRow result;
  for (const Interval& w : wrench) result.push_back(w.low);
  return result;
}

Rational size_of(const RationalRow& wrench, const Rational& length) {
  const auto torque = wrench.begin() + (wrench.size() == 3 ? 2 : 3);
  return std::max(largest({wrench.begin(), torque}),
                  Rational(largest({torque, wrench.end()}) / length));
}

ContactGeometry::ContactGeometry(const UncertainContact& contact)
    : contact_(contact),
      point_(contact.point()),
      square_(dot(contact.normal, contact.normal)) {}

RationalRow ContactGeometry::wrench_of(const RationalRow& force) const {
  return wrench_at(point_, force);
}

RationalRow ContactGeometry::displacement(const RationalRow& d) const {
  if (d.size() == 3) return {d[0] - d[2] * point_[1], d[1] + d[2] * point_[0]};
  const Vector3 moved = stickslip::displacement(vector3(point_), d);
  return {moved.begin(), moved.end()};
}

Rational ContactGeometry::along(const RationalRow& v) const {
  return dot(v, contact_.normal) / square_;
}

RationalRow ContactGeometry::across(const RationalRow& v) const {
  return sum(v, -along(v), contact_.normal);
}

RootSum ContactGeometry::separation(const RationalRow& moved) const {
  return contact_.preload.low - RootSum::root(contact_.stiffness.low * along(moved), square_);
}

int ContactGeometry::slip_sign(const RationalRow& v) const {
  const RationalRow& n = contact_.normal;
  if (n.size() == 2) return Rational(v[1] * n[0] - v[0] * n[1]).sign();
  return largest(across(v)).is_zero() ? 0 : 1;
}

}  // namespace stickslip::crosscheck_detail
