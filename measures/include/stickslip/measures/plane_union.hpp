// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The exact union of convex cells in a plane: areas with their borders (the regularised part),
/// and the thinner rest. As a set of points the union is closed. Its description is unique,
/// whatever cells it came from.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/measures/plane_cell.hpp"

namespace stickslip {

/// A connected piece of an area's border, directed with the area to its left and no vertex
/// between two edges of one direction.
/// A closed outline lists its vertices in cyclic order from the least one, counterclockwise
/// around the outside and clockwise around a hole. A border through a point where an area
/// touches itself has that vertex twice. An open outline goes from infinity (in direction
/// `from`, seen from the first vertex) through the vertices to infinity (in direction `to`); a
/// whole line has the point nearest to the origin as its vertex.
struct Outline {
  std::vector<PlanePoint> vertices;  ///< at least one
  /// \{ The directions of an open outline's ends; nothing for a closed one.
  std::optional<PlaneDirection> from;
  std::optional<PlaneDirection> to;
  /// \}

  bool is_closed() const { return !from; }  ///< whether it is no open outline
  /// The edges in order.
  std::vector<PlaneEdge> edges() const;

  /// Returns true if both are the same border.
  friend bool operator==(const Outline& a, const Outline& b) {
    return a.vertices == b.vertices && a.from == b.from && a.to == b.to;
  }
};

/// A connected open set and its border. Two areas may share single points, but no more. Without
/// any outline the area is the whole plane.
struct PlaneArea {
  std::vector<Outline> outlines;  ///< the outside, if the area is bounded; then the open
                                  ///< outlines; then the holes

  /// Returns true if both are the same set of points.
  friend bool operator==(const PlaneArea& a, const PlaneArea& b) {
    return a.outlines == b.outlines;
  }
};

/// A closed set of points in a plane.
struct PlaneUnion {
  std::vector<PlaneArea> areas;  ///< the interior, in its connected parts
  /// Segments, rays and lines outside of the areas (of their closure), each as long as
  /// possible; two may cross.
  std::vector<PlaneCell> curves;
  std::vector<PlanePoint> points;  ///< outside of all the above

  /// Returns true if no point is in it.
  bool is_empty() const { return areas.empty() && curves.empty() && points.empty(); }
  /// Returns true if every point is in it.
  bool is_whole_plane() const { return areas.size() == 1 && areas.front().outlines.empty(); }
  /// Returns true if the point is in it. O(edges) exact operations.
  bool contains(const PlanePoint& point) const;

  /// Returns true if both are the same set of points.
  friend bool operator==(const PlaneUnion& a, const PlaneUnion& b) {
    return a.areas == b.areas && a.curves == b.curves && a.points == b.points;
  }
};

/// Returns the union, which is exact and independent of the order of the cells. With n edges of
/// cells and k vertices of their overlay it takes O((n + k) log n) exact predicates (Bentley
/// and Ottmann 1979, in CGAL's Arrangement_2).
PlaneUnion unite(const std::vector<PlaneCell>& cells);

/// Returns the part in [low_x, high_x] x [low_y, high_y], for drawing; of areas the interior.
PlaneUnion clip_to_box(const PlaneUnion& region, const PlanePoint& low, const PlanePoint& high);

}  // namespace stickslip
