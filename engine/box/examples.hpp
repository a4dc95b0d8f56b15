// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Single grasps of a box, decided one by one: a verdict that differs from the middle's says
/// that the box has no verdict.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/part.hpp"

namespace stickslip::box_detail {

/// A grasp in a box: where each uncertain number lies, -1 at its low end, 0 in the middle, 1 at
/// its high end. Of a ball of loads a multiple of what is said of its components, in the ball.
using Place = RationalRow;

class Examples {
 public:
  /// `box` must outlive this.
  Examples(const GraspBox& box, NormalLaw law);

  /// The one grasp at this place. Normals are turned by at most the slope; in the plane they
  /// have a rational length where the file's normal has one and the contact is preloaded.
  GraspBox at(const Place& place) const;
  /// The one grasp at these parts of the way from low to high, from 0 to 1, of each parameter
  /// of GraspLaw.
  GraspBox between(const RationalRow& parts) const;
  /// Corners at which this equilibrium of the middle is lost, soonest first, and after which
  /// part of the way.
  std::vector<std::pair<Place, double>> without(const NearEquilibrium& equilibrium) const;
  /// All held better, or worse, as one would think: more friction and preload under less load,
  /// and the reverse. They cost nothing to find.
  std::vector<Place> extremes() const;
  /// One number at either end and all others in the middle, of a few numbers; else nothing.
  std::vector<Place> single_ends() const;
  const GraspBox& box() const { return box_; }  ///< of which they are
  NormalLaw law() const { return law_; }        ///< of all contacts
  /// The uncertain numbers, in the order of a place's entries.
  const std::vector<ParameterId>& numbers() const { return numbers_; }
  Place middle() const { return Place(numbers_.size()); }
  /// Of a ball the loads along each axis of forces and torques, and in the plane between them
  /// as well, in space in the midst of six.
  std::vector<Place> ball_directions() const;
  /// Loads of the ball beside that of a place, along each axis by so much of the ball.
  std::vector<Place> turned(const Place& place, const Rational& step) const;
  /// The same with that load of a ball that does most work on a virtual twist.
  Place loaded_along(const RationalRow& twist, Place place) const;
  /// In a ball, midway between the ways to the loads of two places.
  Place between_loads(const Place& one, const Place& other) const;

 private:
  /// Adds the load of a ball that these components, or a multiple of them in the ball, are of.
  void load(GraspBox& chosen, RationalRow z) const;
  /// Turns the normals of a grasp, by contact each way by a part of the most, from -1 to 1.
  void turn(GraspBox& chosen, const std::vector<RationalRow>& parts) const;

  const GraspBox& box_;
  NormalLaw law_;
  std::vector<ParameterId> numbers_;
};

}  // namespace stickslip::box_detail
