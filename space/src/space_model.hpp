// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A box of grasps in space: rows of its contacts at the corners of their positions, exactly
/// and in doubles (certificate/FORMAT.md, section 7).
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "stickslip/core/integer_vector.hpp"
#include "stickslip/equilibrium/part.hpp"
#include "stickslip/space/spatial_question.hpp"

namespace stickslip::space_detail {

/// x = (d, h, 0), or a linear function of it.
using Point = IntegerVector<8>;
using Double3 = std::array<double, 3>;
using Double6 = std::array<double, 6>;

/// The different ends of an interval.
inline std::vector<Rational> ends_of(const Interval& interval) {
  if (interval.is_point()) return {interval.low};
  return {interval.low, interval.high};
}

/// Calls visit(p) for all corners of a position, z changing from one to the next.
template <class Visit>
void for_each_corner(const std::array<Interval, 3>& position, const Visit& visit) {
  for (const Rational& x : ends_of(position[0])) {
    for (const Rational& y : ends_of(position[1])) {
      for (const Rational& z : ends_of(position[2])) visit(Vector3{x, y, z});
    }
  }
}

/// N and S with the contact at a corner of its position.
struct CornerRow {
  Vector6 normal;                        ///< N
  std::array<IntegerVector<6>, 3> slip;  ///< S times slip_factor, by rows
  Rational slip_factor;                  ///< > 0
  std::array<Point, 3> slip_planes;      ///< the same, as functions of points
  Double6 normal_rounded;                ///< N
  std::array<Double6, 3> slip_rounded;   ///< S
};

struct SpaceContact {
  std::array<Interval, 3> position;
  std::vector<CornerRow> corners;  ///< of the position
  Vector3 normal;                  ///< n
  IntegerVector3 axis;             ///< the same direction
  Rational squared_length;         ///< L^2
  Interval friction;               ///< mu
  Interval preload;                ///< P'
  Interval rate;                   ///< P^u' of a margin, whose ends go with those of P'
  Interval stiffness;              ///< k'
  bool geometry_is_certain;        ///< one corner
  CornerRow centre;                ///< the row of the middle of the position

  /// v at all corners of all parameters, without repetition: positive multiples, and factors
  /// that make them v.
  std::vector<Point> separations;
  std::vector<Rational> separation_factors;
  /// v is one function up to positive factors.
  bool has_certain_separation() const;

  /// \{ In doubles. Slopes are mu L.
  std::array<double, 2> slopes;
  std::array<double, 2> preloads;
  std::array<double, 2> rates;
  std::array<double, 2> stiffnesses;
  std::array<Double3, 2> tangents;  ///< of length 1, across n
  /// Whether rows, preloads, rates and stiffnesses are 0 or between 2^-200 and 2^200, so that
  /// no product with a point of norm 1 overflows or vanishes. If not, doubles decide no sign.
  bool is_moderate;
  /// \}
};

/// In doubles rotations are times `length`, and torques over it.
struct SpaceModel {
  /// Of the box that the question is, with lengths enclosed to these bits.
  SpaceModel(const SpatialQuestion& question, unsigned bits);

  /// The halves below and above a cut of the box; not of a margin.
  std::pair<SpaceModel, SpaceModel> halves(const PartSplit& split) const;
  /// The one point in the middle of the box; of a margin with this multiple.
  SpaceModel at(const Rational& multiple) const;
  /// The same margin for other multiples.
  SpaceModel within(const MultipleRange& range) const;
  /// Whether the box, lengths of normals included, is one point.
  bool is_point() const;
  /// h w + l u of a point with these, in doubles, on y: where its work is largest.
  Double6 load_at(double height, double multiple, const Double6& y) const;

  std::vector<SpaceContact> contacts;
  SpatialWrench wrench;
  Vector6 growth{};           ///< u, of a margin
  bool is_family = false;     ///< a margin: points have multiples
  MultipleRange multiples{};  ///< of a margin
  NormalLaw law;
  double length = 1;                            ///< a typical distance
  double force = 1;                             ///< a typical force
  double reach = 1;                             ///< how far it moves the object
  std::array<std::array<double, 2>, 6> load{};  ///< ends
  Double6 growing{};                            ///< u

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
    const SpaceContact& c = box.contacts[i];
    for (std::size_t j = 0; j < 3; ++j) f(kCoordinates[j], i, c.position[j]);
    f(Parameter::kFriction, i, c.friction);
    f(Parameter::kStiffness, i, c.stiffness);
    f(Parameter::kPreload, i, c.preload);
  }
  for (std::size_t j = 0; j < 6; ++j) f(Parameter::kWrench, j, box.wrench[j]);
}

}  // namespace stickslip::space_detail
