// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/contact_row.hpp"

#include "stickslip/core/error.hpp"
#include "stickslip/core/snap.hpp"

namespace stickslip {
namespace {

Wrench unit_force_at(const Vector2& p, const Rational& fx, const Rational& fy) {
  return {fx, fy, p.x * fy - p.y * fx};
}

}  // namespace

Wrench normal_row(const Contact& contact) {
  return unit_force_at(contact.position, contact.normal.x, contact.normal.y);
}

Wrench tangent_row(const Contact& contact) {
  return unit_force_at(contact.position, -contact.normal.y, contact.normal.x);
}

std::vector<ContactRow> contact_rows(const Grasp& grasp) {
  std::vector<ContactRow> rows;
  rows.reserve(grasp.size());
  for (const Contact& c : grasp.contacts()) {
    const Rational length_squared = c.normal.x * c.normal.x + c.normal.y * c.normal.y;
    Rational preload = 0;
    if (!c.preload.is_zero()) {
      const std::optional<Rational> length = exact_sqrt(length_squared);
      if (!length) {
        throw InputError("", "contacts[" + std::to_string(rows.size()) + "].normal",
                         "the normal (" + to_readable_string(c.normal.x) + ", " +
                             to_readable_string(c.normal.y) +
                             ") of a preloaded contact has the irrational length sqrt(" +
                             to_readable_string(length_squared) + ")",
                         kSnapRemedy);
      }
      preload = c.preload / *length;
    }
    rows.push_back(
        {normal_row(c), tangent_row(c), c.friction, preload, c.stiffness / length_squared});
  }
  return rows;
}

}  // namespace stickslip
