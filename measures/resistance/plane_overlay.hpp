// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The overlay of the borders of bounded cells: which parts of it are inside of cells.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "stickslip/measures/plane_cell.hpp"

namespace stickslip::resistance_detail {

/// A part of the border between inside and outside, with the inside to its left.
struct OverlayChain {
  std::size_t area = 0;  ///< the number of the connected area whose border it is
  /// A cycle, or from one point of the frame to another.
  std::vector<PlanePoint> points;
  bool is_closed = false;
};

struct Overlay {
  std::size_t areas = 0;  ///< connected open sets inside of cells
  std::vector<OverlayChain> chains;
  /// Edges of cells with the outside on both of their sides.
  std::vector<std::pair<PlanePoint, PlanePoint>> thin_edges;
};

/// A segment between two points of a list, with so many more cells to its left than to its
/// right. A cell that is a segment counts for nothing.
struct OverlayEdge {
  std::size_t from = 0;
  std::size_t to = 0;
  int cells = 0;
};

/// Returns the overlay; inside means in at least `least` cells. Requires segments that are no
/// points, together the whole borders of bounded cells. If frame > 0, all must lie in the
/// square [-frame, frame]^2, and its sides are no borders: the inside goes on beyond them. It
/// is faster if each point is listed once.
Overlay overlay(const std::vector<PlanePoint>& points, const std::vector<OverlayEdge>& edges,
                const Integer& frame, int least);

}  // namespace stickslip::resistance_detail
