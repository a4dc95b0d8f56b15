// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_law.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/core/contact_row.hpp"

namespace stickslip::box_detail {
namespace {

/// The contact at each corner of its geometry: x, y and turn, the last of these slowest.
std::vector<Contact> corners_of(const ParameterContact& contact) {
  const auto ends = [&](Parameter parameter) {
    return ends_of(contact.parameters[static_cast<std::size_t>(parameter)]);
  };
  std::vector<Contact> corners;
  for (const Rational& e : ends(Parameter::kTurn)) {
    for (const Rational& y : ends(Parameter::kY)) {
      for (const Rational& x : ends(Parameter::kX)) {
        corners.push_back({{x, y}, turned(contact.normal, e)});
      }
    }
  }
  return corners;
}

RationalRow as_row(const Wrench& wrench) {
  return {wrench.x, wrench.y, wrench.torque};
}

}  // namespace

Law law_of(const ParameterBox& box) {
  Law result;
  result.wrench.assign(box.wrench().begin(), box.wrench().end());
  result.law = box.law();
  double farthest = 0;
  for (const ParameterContact& c : box.contacts()) {
    const auto interval = [&](Parameter parameter) {
      return c.parameters[static_cast<std::size_t>(parameter)];
    };
    LawContact& contact = result.contacts.emplace_back();
    contact.friction = interval(Parameter::kFriction);
    contact.preload = interval(Parameter::kPreload);
    contact.stiffness = interval(Parameter::kStiffness);
    for (const Contact& corner : corners_of(c)) {
      CornerRow& row = contact.corners.emplace_back();
      row.normal = as_row(normal_row(corner));
      row.set_slip({as_row(tangent_row(corner))}, 1);
      farthest = std::max({farthest, std::fabs(to_double(corner.position.x)),
                           std::fabs(to_double(corner.position.y))});
    }
  }
  result.complete(farthest);
  return result;
}

}  // namespace stickslip::box_detail
