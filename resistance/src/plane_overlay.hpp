// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The overlay of bounded cells: which parts of it are inside of some cell.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "stickslip/resistance/plane_cell.hpp"

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

/// Requires bounded cells of dimension 1 or 2. If frame > 0, all lie in the square
/// [-frame, frame]^2, and its sides are no borders: the inside goes on beyond them.
Overlay overlay(const std::vector<PlaneCell>& cells, const Integer& frame);

}  // namespace stickslip::resistance_detail
