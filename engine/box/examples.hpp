// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Single grasps of a box, decided one by one: a verdict that differs from the middle's says
/// that the box has no verdict.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "engine/degree/rounded_box.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/part.hpp"

namespace stickslip::box_detail {

/// The place of a grasp in a box: where each uncertain number lies, -1 at its low end, 0 in the
/// middle, 1 at its high end. A load that is not in a ball is pulled to its border.
using Place = RationalRow;

class Examples {
 public:
  /// `box` must outlive this.
  Examples(const GraspBox& box, NormalLaw law);

  /// Returns the one grasp at this place. Normals are turned by at most the slope; in the plane
  /// they have a rational length where the file's normal has one and the contact is preloaded.
  GraspBox at(const Place& place) const;
  /// Returns the place of a grasp of the box; nothing if a normal of it is turned, or if there
  /// is a ball of loads.
  std::optional<Place> place_of(const GraspBox& grasp) const;
  /// Returns the one grasp at these parts of the way from low to high, from 0 to 1, of each
  /// parameter of GraspLaw.
  GraspBox between(const RationalRow& parts) const;
  /// Visits the weakest corners, weakest first, at which Newton's method finds no equilibrium,
  /// neither from this one of the middle nor from others, until `visit` returns false.
  void visit_weak_corners(const NearEquilibrium& equilibrium,
                          const std::function<bool(const Place&)>& visit) const;
  /// Visits such corners among 64 drawn at random, with normals turned every way.
  void visit_random_corners(const NearEquilibrium& equilibrium,
                            const std::function<bool(const Place&)>& visit) const;
  /// Returns two places at which all is held better, and worse, as one would think: more
  /// friction and preload under less load, and the reverse. They cost nothing to find.
  std::vector<Place> extremes() const;
  /// Returns the places with one number at either end and all others in the middle; none if
  /// there are more than `most` numbers.
  std::vector<Place> single_ends(std::size_t most) const;
  const GraspBox& box() const { return box_; }  ///< the box that they are of
  NormalLaw law() const { return law_; }        ///< the law of all contacts
  /// Returns the uncertain numbers, in the order of a place's entries.
  const std::vector<ParameterId>& numbers() const { return numbers_; }
  Place middle() const { return Place(numbers_.size()); }
  /// Returns the loads of a ball along each axis of forces and torques; in the plane those
  /// between axes as well, in space those in the midst of all six.
  std::vector<Place> ball_directions() const;
  /// Returns loads of the ball beside that of a place, along each axis by so much of the ball.
  std::vector<Place> turned(const Place& place, const Rational& step) const;
  /// Returns the place with the load of a ball that does most work on a virtual twist.
  Place loaded_along(const RationalRow& twist, Place place) const;
  /// Returns, for a ball, a place midway between the ways to the loads of two places.
  Place between_loads(const Place& one, const Place& other) const;

 private:
  /// Returns the place of a rounded box that has the same numbers.
  Place place_at(const RoundedBox& rounded, const RoundedBox::Place& at) const;
  /// Adds the load of a ball with these components, or with a multiple of them in the ball.
  void load(GraspBox& chosen, RationalRow z) const;
  /// Turns the normals of a grasp, for each contact each way by a part of the most, from -1
  /// to 1.
  void turn(GraspBox& chosen, const std::vector<RationalRow>& parts) const;

  const GraspBox& box_;
  NormalLaw law_;
  std::vector<ParameterId> numbers_;
};

}  // namespace stickslip::box_detail
