// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The quality of a passive grasp: the radius of the largest ball of loads around its own that
/// it resists, between two numbers. (Of forces that a hand exerts at will, C. Ferrari and J.
/// Canny, "Planning optimal grasps", 1992; of those that arise there is no formula, and what is
/// resisted is neither convex nor star-shaped.)
#pragma once

#include <functional>
#include <optional>

#include "stickslip/measures/radius.hpp"

namespace stickslip {

/// What a search for a quality may do.
struct QualityOptions {
  RadiusOptions radius{};             ///< of each proof, and when to stop
  std::optional<Rational> at_most{};  ///< no larger ball is of interest; nothing: 64 times a
                                      ///< typical force
};

/// Radii of balls of loads.
struct Quality {
  std::optional<bool> stable;         ///< whether the load in the centre is resisted
  Rational proved{0};                 ///< all of this ball is resisted; 0 where none is proved
  std::optional<Rational> refuted{};  ///< of this one some load is not
  Rational limit{0};                  ///< nothing above was tried
  /// Without loads, preloads and a bound on motions all multiples of a load are resisted, or
  /// none: a proof about one ball is about all.
  bool scales = false;
  GraspBox ball{};  ///< the grasp with a ball of which `radii` has factors
  Radius radii{};   ///< with the proof, and the load that is not resisted
};

/// The quality of one grasp for balls of this length, point and body (its radius is of no
/// matter). Throws InputError as GraspBox::check() does. `progress` is called with what is
/// known so far.
Quality find_quality(const GraspBox& grasp, NormalLaw law, LoadBall shape,
                     const QualityOptions& options = {},
                     const std::function<void(const Quality&)>& progress = {});

}  // namespace stickslip
