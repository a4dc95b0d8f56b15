// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/contact_row.hpp"

#include <utility>

#include "short_arithmetic.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/snap.hpp"

namespace stickslip {

using namespace core_detail;

namespace {

Vector2 tangent_of(const Contact& contact) {
  return {-contact.normal.y, contact.normal.x};
}

Wrench unit_force_at(const Vector2& p, Vector2 force) {
  Rational torque = determinant(p, force);
  return {std::move(force.x), std::move(force.y), std::move(torque)};
}

}  // namespace

Wrench normal_row(const Contact& contact) {
  return unit_force_at(contact.position, contact.normal);
}

Wrench tangent_row(const Contact& contact) {
  return unit_force_at(contact.position, tangent_of(contact));
}

std::vector<ContactRow> contact_rows(const Grasp& grasp) {
  std::vector<ContactRow> rows;
  rows.reserve(grasp.size());
  for (const Contact& c : grasp.contacts()) {
    const Rational length_squared = determinant(c.normal, tangent_of(c));
    Rational preload;
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
        {normal_row(c), tangent_row(c), c.friction, std::move(preload),
         length_squared == 1 ? c.stiffness : Rational(c.stiffness / length_squared)});
  }
  return rows;
}

}  // namespace stickslip
