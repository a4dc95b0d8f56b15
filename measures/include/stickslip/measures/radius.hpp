// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The robustness of a verdict: by which factor tolerances may grow.
#pragma once

#include <functional>
#include <optional>

#include "stickslip/engine/box_verdict.hpp"

namespace stickslip {

/// The limits of a search for a radius.
struct RadiusOptions {
  SearchOptions box;  ///< the options of each proof
  /// The search stops when the two radii differ by this part of the larger one; while they
  /// differ by more than a third, proofs are sought to a part of 1/50 at least.
  Rational accuracy{1, 100};
  Rational most{64};         ///< no factor beyond this is tried
  bool only_stable = false;  ///< nothing is sought about a centre that is unstable
};

/// Counterexamples are sought down to factors of about this size. If there are some, the centre
/// is on a threshold, or nearer to one than matters, and no proof is sought.
inline const Rational kLeastFactor{1, 1 << 20};

/// Factors of the tolerances about the grasp in the centre.
struct Radius {
  std::optional<bool> stable;  ///< the centre's verdict: the factor 0; nothing if undecided
  Rational proved{0};  ///< the largest factor with a proof of the centre's verdict; 0: none
  std::optional<BoxDecision> proof{};  ///< the proof for `proved`, unless that is 0
  std::optional<Rational> refuted{};   ///< the smallest factor with a counterexample
  std::optional<GraspBox> example{};   ///< the counterexample
  /// The largest factor that was allowed: RadiusOptions::most, or less where a larger factor
  /// would make the box invalid (GraspBox::check()).
  Rational limit{0};

  /// Returns whether counterexamples are as near as any that are sought.
  bool is_on_threshold() const { return refuted && *refuted <= 2 * kLeastFactor; }
};

/// Returns the radii of `centre`, one grasp, in the tolerances that `box` gives it: proved <
/// refuted. Nothing is known between them. They are no worse than what decide_box() says of the
/// box itself. If the verdict of the centre itself is undecided,
/// `proved` is 0. Calls `progress` with the radii so far.
Radius find_radius(const GraspBox& centre, const GraspBox& box, NormalLaw law,
                   const RadiusOptions& options = {},
                   const std::function<void(const Radius&)>& progress = {});

}  // namespace stickslip
