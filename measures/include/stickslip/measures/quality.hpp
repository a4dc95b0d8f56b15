// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The quality of a passive grasp: the radius of the largest ball of loads around its own that
/// it resists, between two numbers. (C. Ferrari and J. Canny, "Planning optimal grasps", 1992,
/// have the radius for forces that a hand exerts at will. Passive forces have no formula, and
/// the set of loads that they resist is neither convex nor star-shaped.)
#pragma once

#include <functional>
#include <optional>

#include "stickslip/measures/radius.hpp"

namespace stickslip {

/// The limits of a search for a quality.
struct QualityOptions {
  RadiusOptions radius{};             ///< the options of each proof, and when to stop
  std::optional<Rational> at_most{};  ///< no larger ball is of interest; nothing: 64 times a
                                      ///< typical force
};

/// Bounds of the quality, the radius of the largest ball of loads that is resisted: it
/// is at least `proved` and below `refuted`.
struct Quality {
  std::optional<bool> stable;  ///< whether the load in the centre is resisted
  Rational proved{0};          ///< the grasp resists all of this ball; 0 if none is proved
  std::optional<Rational> refuted{};  ///< the grasp does not resist some load of this ball
  Rational limit{0};                  ///< no larger radius was tried
  /// Whether one proof is about the balls of all sizes, so that all are resisted or none.
  /// Without loads, preloads and a bound on motions a grasp resists all multiples of a load, or
  /// none.
  bool scales = false;
  GraspBox ball{};  ///< the grasp with a ball whose radius the factors of `radii` multiply
  Radius radii{};   ///< the factors with the proof; its example has a load that is not resisted
};

/// Returns the quality of one grasp for balls of this length, point and body; the radius of
/// `shape` does not matter. Throws InputError as GraspBox::check() does. Calls `progress` with
/// what is known so far.
Quality find_quality(const GraspBox& grasp, NormalLaw law, LoadBall shape,
                     const QualityOptions& options = {},
                     const std::function<void(const Quality&)>& progress = {});

}  // namespace stickslip
