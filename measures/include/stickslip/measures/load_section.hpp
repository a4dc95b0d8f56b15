// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Plane sections of the balls of a quality: sections by forces, and one through the load that
/// is not resisted.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "stickslip/measures/map.hpp"
#include "stickslip/measures/quality.hpp"

namespace stickslip {

/// A section is looked at up to this many radii of the larger ball.
inline constexpr int kSectionReach = 2;

/// The loads w + s u + t v, with w in the centre of the balls, and u and v each the load of a
/// force or of a torque at their point. u and v are orthogonal in the norm of balls, |f|^2 +
/// |tau|^2 / length^2; so with s and t times their norms as coordinates, each ball is the disc
/// of its radius.
struct LoadSection {
  /// How far to look along u and along v, about equally far in the norm.
  std::array<MapAxis, 2> axes;
  /// f and tau of u, and those of v: three numbers, in space six.
  std::array<RationalRow, 2> along;
  /// The coordinates s and t of the load that is not resisted, if it is in the section.
  std::optional<std::array<Rational, 2>> lost{};

  /// Returns the square of the norm of u (0) or v (1).
  Rational squared_norm(std::size_t axis, const LoadBall& ball) const;
};

/// Returns the sections of forces along each pair of axes and, if a load that is not resisted
/// is known, the section of its force and its torque (the first axis replaces a force of 0, the
/// last one a torque of 0). Empty if no ball has a radius.
std::vector<LoadSection> load_sections(const Quality& quality);

}  // namespace stickslip
