// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How many of some cells each point of a plane is in, kept by where the number changes.
///
/// Of each cell it is enough to know its border, with the cell to its left. Where the borders
/// of two cells run against one another along one edge, as those of neighbours do, the number
/// is the same on both sides, and the edge goes. What is left still tells the numbers of all
/// faces between edges, as the number changes by what is known across each; and a point of an
/// edge that went is in the cells whose border it was, as cells are closed.
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
  /// Each as one cell, whatever its shape.
  void add(const std::vector<PlaneArea>& areas);
  /// Of cells of dimension 2: their number to the left of the edge, less that to its right.
  void add_border(const PlaneEdge& edge, int cells);
  /// Of an unbounded cell: it goes to infinity from one direction counterclockwise to another,
  /// less than half a turn.
  void add_arc(const PlaneDirection& from, const PlaneDirection& to);

  /// Edges of borders that are left.
  std::size_t edges() const { return edges_.size(); }
  /// The points that are in at least so many cells; segments and points among the cells are
  /// left as they are.
  PlaneUnion covered(int least = 1) const;

 private:
  bool is_bounded() const;
  PlaneDirection clear_direction() const;
  int cells_towards(const PlaneDirection& direction) const;
  Integer half_side(const PlaneDirection& clear) const;

  using Ends = std::pair<HomogeneousPoint, HomogeneousPoint>;
  std::map<Ends, int> edges_;  ///< the less end first; not 0
  std::vector<std::pair<PlaneDirection, PlaneDirection>> arcs_;
  std::vector<PlaneArea> unbounded_;
  std::set<PlaneCell> thin_;  ///< of dimension 0 and 1
};

}  // namespace stickslip::resistance_detail
