// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The number of cells that each point of a plane is in, kept by where this number changes.
///
/// A cell is stored by its border alone, with the cell to its left. If the borders of two cells
/// run against one another along one edge, as those of neighbours do, the number is the same on
/// both sides, and the edge goes. The remaining edges still tell the numbers of all faces
/// between them, as the number changes by a known step across each. A point of an edge that
/// went is in the cells whose border it was, as cells are closed.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "plane_overlay.hpp"
#include "stickslip/measures/plane_union.hpp"

namespace stickslip::resistance_detail {

class PlaneCover {
 public:
  void add(const PlaneCell& cell);
  /// Adds each area as one cell, whatever its shape.
  void add(const std::vector<PlaneArea>& areas);
  /// Adds an edge of cells of dimension 2: `cells` is their number to its left, less that to
  /// its right.
  void add_border(const PlaneEdge& edge, int cells);
  /// Adds the part at infinity of an unbounded cell, from one direction counterclockwise to
  /// another, less than half a turn.
  void add_arc(const PlaneDirection& from, const PlaneDirection& to);

  /// Returns the number of edges of borders that are left.
  std::size_t edges() const { return edges_.size(); }
  /// Returns the points that are in at least so many cells. Cells that are segments and points
  /// stay as they are.
  PlaneUnion covered(int least = 1) const;

 private:
  bool is_bounded() const;
  PlaneDirection clear_direction() const;
  int cells_towards(const PlaneDirection& direction) const;
  Integer half_side(const PlaneDirection& clear) const;

  using Ends = std::pair<HomogeneousPoint, HomogeneousPoint>;
  std::map<Ends, int> edges_;  ///< the lesser end first; no number is 0
  std::vector<std::pair<PlaneDirection, PlaneDirection>> arcs_;
  std::vector<PlaneArea> unbounded_;
  std::set<PlaneCell> thin_;  ///< cells of dimension 0 and 1
};

}  // namespace stickslip::resistance_detail
