// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The outline of a body, and the places on it where contacts can be.
#pragma once

#include <vector>

#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// An edge of an outline, in the direction in which its ring runs.
struct OutlineEdge {
  Vector2 from;  ///< a vertex
  Vector2 to;    ///< the next one
  /// A vector into the body, across the edge. It has length 1 if the length of the edge is
  /// rational, else the length of the edge.
  Vector2 inwards;

  /// Returns the point at this share of the way from `from` to `to`.
  Vector2 at(const Rational& share) const;
};

/// Checks an outline. Throws InputError at "outline[j][k]", ring k of polygon j, unless each
/// polygon has a ring, and each ring has at least three vertices, none of them like the next,
/// and an area. Throws it at "outline[j]" if rings of a polygon cross or touch themselves or
/// each other, or if its holes are not inside.
void check_outline(const std::vector<Polygon>& outline);

/// Returns the edges of each polygon: those of its rings, one ring after another. Requires an
/// outline that check_outline accepts.
std::vector<std::vector<OutlineEdge>> outline_edges(const std::vector<Polygon>& outline);

}  // namespace stickslip
