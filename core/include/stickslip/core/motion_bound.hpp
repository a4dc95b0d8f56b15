// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Bounds of motions, for questions about equilibria whose motions are of the size of the
/// problem alone (certificate/FORMAT.md, section 1, *max motion*).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/core/box.hpp"

namespace stickslip {

/// A bound of motions in the form in which somebody asks for it.
struct MotionBound {
  /// A number for each coordinate of motions; or two, a length and an angle; or none for no
  /// bound.
  RationalRow numbers{};
  /// The factor of the natural motion of the grasp, instead of numbers.
  std::optional<Rational> factor{};
};

/// The factor of the natural motion above which motions are far larger than any that forces of
/// the load's size explain.
inline constexpr int kFarMotion = 1000;

/// Reads "0.01,0.02", "1000x" or "none". Throws InputError with the place "max_motion".
MotionBound parse_motion_bound(std::string_view text);

/// Returns B for this grasp: a number above 0 for each coordinate of motions; empty for no
/// bound. Throws InputError with the place "max_motion" for other numbers than the grasp needs,
/// and for a factor where the grasp has no natural motion.
RationalRow bound_of(const GraspBox& box, const MotionBound& asked);

/// Returns whether |d_j| <= B_j for each coordinate of a motion d; always, if the bound is
/// empty.
bool is_within(const RationalRow& motion, const RationalRow& bound);

/// Returns `factor` times the natural motion of the grasp, rounded up to two digits. The
/// natural motion is how far load and preloads together press the softest contact or spring,
/// delta = (|w| + sum of P) / k, and for rotations delta over the spread of the contacts. A
/// translation is that of the origin, and so is larger where the origin is far away. Frames
/// turn its axes; units do not matter. Returns nothing if there is no contact, or neither load
/// nor preload. O(contacts).
std::optional<RationalRow> natural_bound(const GraspBox& box, const Rational& factor);

/// Returns a length by which torques may be compared with forces where nobody gives one: half
/// of the widest side of the box around the contacts, rounded up to two digits; of one point
/// its distance from the origin, or 1. O(contacts).
Rational characteristic_length(const GraspBox& box);

/// Returns the grasp with a load and preloads that are larger by these, which is the member 1
/// of a margin. The preloads are those of contacts and then the forces of springs. Empty rows
/// add nothing.
GraspBox grown(GraspBox box, const RationalRow& load, const std::vector<Rational>& preloads);

}  // namespace stickslip
