// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/spatial_grasp.hpp"

#include <utility>

#include "stickslip/core/error.hpp"
#include "uncertain_contact.hpp"

namespace stickslip {

using namespace core_detail;

void check(const SpatialGrasp& grasp) {
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const SpatialContact& c = grasp.contacts[i];
    const std::string path = "contacts[" + std::to_string(i) + "]";
    for (std::size_t j = 0; j < 3; ++j) {
      check_ends(c.position[j], path + ".position[" + std::to_string(j) + "]");
    }
    if (dot(c.normal, c.normal).is_zero()) {
      throw InputError("", path + ".normal", "the normal is (0, 0, 0)",
                       "give a nonzero vector that points into the object");
    }
    check_laws(c.friction, c.stiffness, c.preload, path);
  }
  for (std::size_t j = 0; j < grasp.wrench.size(); ++j) {
    check_ends(grasp.wrench[j], "wrench[" + std::to_string(j) + "]");
  }
}

SpatialGrasp widened(SpatialGrasp grasp, const Tolerances& tolerances) {
  if (tolerances.normal) {
    throw InputError("", "uncertain", "a tolerance of normals, but the grasp is in space",
                     "normals in space are certain; leave it out");
  }
  const auto widen = [](Interval& interval, const std::optional<Tolerance>& tolerance) {
    if (tolerance) interval = tolerance->widen(interval);
  };
  for (SpatialContact& c : grasp.contacts) {
    for (Interval& coordinate : c.position) widen(coordinate, tolerances.position);
    widen(c.friction, tolerances.friction);
    widen(c.stiffness, tolerances.stiffness);
    widen(c.preload, tolerances.preload);
  }
  for (Interval& component : grasp.wrench) widen(component, tolerances.wrench);
  core_detail::check_widened(tolerances, [&] { check(grasp); });
  return grasp;
}

bool SpatialGrasp::is_point() const {
  bool all = true;
  for_each_number(*this, [&](const std::string& /*place*/, const Interval& interval) {
    all = all && interval.is_point();
  });
  return all;
}

const std::string& name_of(const AnyGraspFile& file) {
  if (const auto* grasp = std::get_if<SpatialGrasp>(&file)) return grasp->name;
  return std::get<GraspFile>(file).content.grasp.name();
}

}  // namespace stickslip
