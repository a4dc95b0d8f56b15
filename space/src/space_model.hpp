// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The law of a box of grasps in space (certificate/FORMAT.md, section 7).
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "stickslip/core/integer_vector.hpp"
#include "stickslip/equilibrium/part.hpp"
#include "stickslip/search/law.hpp"
#include "stickslip/space/spatial_question.hpp"

namespace stickslip::space_detail {

/// Calls visit(p) for all corners of a position, z changing from one to the next.
template <class Visit>
void for_each_corner(const std::array<Interval, 3>& position, const Visit& visit) {
  for (const Rational& x : ends_of(position[0])) {
    for (const Rational& y : ends_of(position[1])) {
      for (const Rational& z : ends_of(position[2])) visit(Vector3{x, y, z});
    }
  }
}

/// Of the box that a question is, or of a part of it.
struct SpaceModel : Law {
  /// With lengths enclosed to these bits.
  SpaceModel(const SpatialQuestion& question, unsigned bits);

  /// The halves below and above a cut of the box; not of a margin.
  std::pair<SpaceModel, SpaceModel> halves(const PartSplit& split) const;
  /// The one point in the middle of the box; of a margin with this multiple.
  SpaceModel at(const Rational& multiple) const;
  /// The same margin for other multiples.
  SpaceModel within(const MultipleRange& range) const;

 private:
  Interval& interval(Parameter parameter, std::size_t index);
  void complete();
};

/// Calls f(parameter, index, interval) of all parameters of a box, in the order of
/// for_each_number().
template <class Function>
void for_each_parameter(const SpaceModel& box, Function f) {
  constexpr Parameter kCoordinates[] = {Parameter::kX, Parameter::kY, Parameter::kZ};
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const LawContact& c = box.contacts[i];
    for (std::size_t j = 0; j < 3; ++j) f(kCoordinates[j], i, c.place->position[j]);
    f(Parameter::kFriction, i, c.friction);
    f(Parameter::kStiffness, i, c.stiffness);
    f(Parameter::kPreload, i, c.preload);
  }
  for (std::size_t j = 0; j < 6; ++j) f(Parameter::kWrench, j, box.wrench[j]);
}

}  // namespace stickslip::space_detail
