// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/resistible_set.hpp"

#include <string>

#include "mode_walk.hpp"
#include "stickslip/core/error.hpp"
#include "still_cell.hpp"

namespace stickslip {

using namespace resistance_detail;

WrenchPlane::WrenchPlane(const Wrench& origin, const Wrench& u, const Wrench& v)
    : origin_(origin), u_(u), v_(v) {
  const Vector3 a = stickslip::coordinates(u);
  const Vector3 b = stickslip::coordinates(v);
  const Vector3 normal = cross(a, b);
  const Rational area = dot(normal, normal);
  if (area.is_zero()) {
    throw InputError("", "plane", "its two directions are multiples of one another",
                     "give two independent directions, such as 1,0,0 and 0,1,0");
  }
  dual_ = {cross(b, normal), cross(normal, a), normal};
  for (Vector3& vector : dual_) {
    for (Rational& entry : vector) entry /= area;
  }
}

WrenchPlane WrenchPlane::forces(const Rational& torque) {
  return {{0, 0, torque}, {1, 0, 0}, {0, 1, 0}};
}

Wrench WrenchPlane::at(const PlanePoint& point) const {
  return origin_ + (point[0] * u_ + point[1] * v_);
}

Vector4 WrenchPlane::coordinates(const Vector3& w, const Rational& h) const {
  const Vector3 o = stickslip::coordinates(origin_);
  const Vector3 from_origin{w[0] - h * o[0], w[1] - h * o[1], w[2] - h * o[2]};
  return {dot(dual_[0], from_origin), dot(dual_[1], from_origin), dot(dual_[2], from_origin),
          h};
}

std::variant<ResistibleSet, Undecided> resistible_set(const Problem& problem,
                                                      const WrenchPlane& plane,
                                                      const ResistibleOptions& options,
                                                      ResistibleWork* work) {
  ResistibleWork unused;
  ResistibleWork& counters = work != nullptr ? *work : unused;
  counters = {};
  MotionRays rays(problem);
  ModeImages images(problem, plane, rays);
  ModeSections sections(rays, images, options.pieces, counters);
  if (!walk_modes(problem, rays, images, options, counters, sections)) {
    return Undecided{
        "there are more than " + std::to_string(options.mode_limit) + " contact modes", "modes",
        "a higher mode limit may tell"};
  }
  if (const auto cell = still_cell(rays, images)) sections.add_still(*cell);
  return sections.united();
}

}  // namespace stickslip
