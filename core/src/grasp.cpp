// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/grasp.hpp"

#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/core/outline.hpp"

namespace stickslip {
namespace {

void check(bool good, std::size_t contact, const char* member, const Rational& value,
           const char* remedy) {
  if (good) return;
  throw InputError("", "contacts[" + std::to_string(contact) + "]." + member,
                   "the value is " + to_string(value), remedy);
}

void check_preload(std::size_t contact, const Rational& preload) {
  check(preload.sign() >= 0, contact, "preload", preload,
        "a preload is a normal force and must be 0 or more");
}

void check_unit(const char* place, const std::string& unit) {
  if (!unit.empty() && unit.size() <= kMaxUnitLength) return;
  throw InputError(
      "", place, "the unit is " + quote(unit),
      "a unit is short, such as \"mm\": 1 to " + std::to_string(kMaxUnitLength) + " bytes");
}

}  // namespace

const char* to_string(NormalLaw law) {
  return law == NormalLaw::kUnilateral ? "unilateral" : "bilateral";
}

Grasp::Grasp(std::vector<Contact> contacts, std::string name)
    : Grasp(std::move(contacts), GraspDescription{std::move(name)}) {}

Grasp::Grasp(std::vector<Contact> contacts, GraspDescription description)
    : contacts_(std::move(contacts)), description_(std::move(description)) {
  check_outline(description_.outline);
  if (description_.units) {
    check_unit("units.length", description_.units->length);
    check_unit("units.force", description_.units->force);
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Contact& c = contacts_[i];
    if (c.normal.x.is_zero() && c.normal.y.is_zero()) {
      throw InputError("", "contacts[" + std::to_string(i) + "].normal", "the normal is (0, 0)",
                       "give a nonzero vector that points into the object");
    }
    check(c.friction.sign() >= 0, i, "friction", c.friction, "friction must be 0 or more");
    check(c.stiffness.sign() > 0, i, "stiffness", c.stiffness, "stiffness must be above 0");
    check_preload(i, c.preload);
  }
}

Grasp Grasp::with_preload(const Rational& preload) const {
  return with_preloads(std::vector<Rational>(size(), preload));
}

Grasp Grasp::with_preloads(const std::vector<Rational>& preloads) const {
  require(preloads.size() == size(), "one preload for each contact is needed");
  Grasp result = *this;
  for (std::size_t i = 0; i < size(); ++i) {
    check_preload(i, preloads[i]);
    result.contacts_[i].preload = preloads[i];
  }
  return result;
}

}  // namespace stickslip
