// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The outline of a body, and the places on it where contacts can be.
#pragma once

#include <vector>

#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// An edge of an outline, in the sense of its ring.
struct OutlineEdge {
  Vector2 from;  ///< a vertex
  Vector2 to;    ///< the next one
  Vector2
      inwards;  ///< into the body; of length 1 if the edge's is rational, else as long as it

  /// The point at this share of the way.
  Vector2 at(const Rational& share) const;
};

/// Throws InputError at "outline[j][k]", ring k of polygon j, unless each polygon has a ring,
/// and each ring has at least three vertices, none of them like the next, and an area; and at
/// "outline[j]" if rings of a polygon cross or touch themselves or each other, or its holes are
/// not inside.
void check_outline(const std::vector<Polygon>& outline);

/// The edges of each polygon: those of its rings, one ring after another. Requires what
/// check_outline checks.
std::vector<std::vector<OutlineEdge>> outline_edges(const std::vector<Polygon>& outline);

}  // namespace stickslip
