// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The quality of a passive grasp: the radius of the largest ball of loads (LoadBall) around
/// its own load that it resists. It is enclosed between two numbers. (C. Ferrari and J. Canny,
/// "Planning optimal grasps", 1992, have the radius for forces that a hand exerts at will. For
/// passive forces there is no formula, and the set of loads that they resist is neither convex
/// nor star-shaped.)
#pragma once

#include <functional>
#include <optional>

#include "stickslip/measures/radius.hpp"

namespace stickslip {

/// The limits of a search for a quality.
struct QualityOptions {
  RadiusOptions radius{};  ///< the options of each proof, and when to stop
  /// The largest radius that is tried, a force. Nothing: RadiusOptions::most, 64, times a power
  /// of two above the largest force of load and preloads.
  std::optional<Rational> at_most{};
};

/// Bounds of the quality, the radius of the largest ball of loads that is resisted: it
/// is at least `proved` and below `refuted`.
struct Quality {
  std::optional<bool>
      stable;          ///< whether the load in the centre is resisted; nothing: undecided
  Rational proved{0};  ///< the largest radius with a proof; 0: none is proved
  std::optional<Rational> refuted{};  ///< the smallest radius with a load that is not resisted
  Rational limit{0};                  ///< the largest radius that was allowed
  /// Whether one proof is about balls of all sizes, so that the grasp resists all or none. That
  /// is so if there are no load, no preloads and no bound on motions: forces and motions may
  /// then be multiplied together.
  bool scales = false;
  GraspBox
      ball{};  ///< the grasp with a ball of a radius R; the radii above are factors times R
  /// The factors of R: the proof of the ball with `proved`, and as the counterexample a grasp
  /// whose load is in the ball with `refuted` and is not resisted.
  Radius radii{};
};

/// Returns the quality of one grasp for balls of this length, point and body; the radius of
/// `shape` does not matter. Calls `progress` with what is known so far. Throws ContractError if
/// a number of the grasp is uncertain, and InputError as GraspBox::check() does.
Quality find_quality(const GraspBox& grasp, NormalLaw law, LoadBall shape,
                     const QualityOptions& options = {},
                     const std::function<void(const Quality&)>& progress = {});

}  // namespace stickslip
