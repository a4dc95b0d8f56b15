// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Planes of loads in which the balls of a quality are looked at: those of forces, and one with
/// the load that is not resisted.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "stickslip/measures/map.hpp"
#include "stickslip/measures/quality.hpp"

namespace stickslip {

/// How far a section is looked at, in radii of the larger ball.
inline constexpr int kSectionReach = 2;

/// Loads w + s u + t v, with w in the centre of the balls, and u and v each the load of a force
/// or of a torque at their point. These are across each other in the norm of balls, |f|^2 +
/// |tau|^2 / length^2; so there, with s and t times their norms as coordinates, each ball is
/// the disc of its radius.
struct LoadSection {
  /// Along u, and v: how far to look, about equally far in the norm.
  std::array<MapAxis, 2> axes;
  /// f and tau of u, and of v: three numbers, in space six.
  std::array<RationalRow, 2> along;
  /// Where the load that is not resisted is, if it is there: s and t.
  std::optional<std::array<Rational, 2>> lost{};

  /// The square of the norm of u (0) or v (1).
  Rational squared_norm(std::size_t axis, const LoadBall& ball) const;
};

/// Of forces along each two axes; and, of a load that is not resisted, that of its force and
/// its torque (where one is 0: of the first axis, of the last). Nothing if no ball has a
/// radius.
std::vector<LoadSection> load_sections(const Quality& quality);

}  // namespace stickslip
