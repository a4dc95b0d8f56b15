// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Closed convex polyhedra in a plane, bounded or not, by exact generators:
/// conv(points) + cone(directions).
///
/// Points and directions have homogeneous coordinates g = (x, y, h), h >= 0: the point
/// (x/h, y/h) if h > 0, the direction (x, y) if h = 0. A polyhedron is then the section of the
/// cone of its generators by the plane h = 1. Turning is counterclockwise from x to y.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip {

using PlanePoint = std::array<Rational, 2>;  ///< (x, y)
using PlaneDirection = IntegerVector<2>;     ///< primitive
using HomogeneousPoint = IntegerVector<3>;   ///< g = (x, y, h), h >= 0

/// \{ Return primitive coordinates, with h > 0 for a point and h = 0 for a direction.
HomogeneousPoint homogeneous(const PlanePoint& point);
HomogeneousPoint homogeneous(const PlaneDirection& direction);
/// \}
/// Returns (x/h, y/h). Requires h > 0.
PlanePoint point_of(const HomogeneousPoint& g);
/// Returns (x, y), primitive. Meant for h = 0.
PlaneDirection direction_of(const HomogeneousPoint& g);
/// Returns true if h = 0.
inline bool is_at_infinity(const HomogeneousPoint& g) {
  return g[2].is_zero();
}

/// Returns a positive number if b is less than half a turn counterclockwise of a, 0 if they are
/// parallel, and else a negative one.
int turn(const PlaneDirection& a, const PlaneDirection& b);
/// Returns a positive number iff a, b, c turn left.
Integer determinant(const HomogeneousPoint& a, const HomogeneousPoint& b,
                    const HomogeneousPoint& c);

/// A directed segment, or a directed ray if one end is at infinity.
struct PlaneEdge {
  HomogeneousPoint from;  ///< where it starts
  HomogeneousPoint to;    ///< where it ends

  /// Returns a positive multiple of the direction.
  PlaneDirection direction() const;
};

/// A closed convex polyhedron that is not empty. It is stored in one form only, so that equal
/// sets compare equal:
/// - without a line in it: the extreme points, and at most two extreme directions;
/// - with a line: a point on each of its at most two borders (or of the line), the one nearest
///   to the origin; the line's direction both ways, and for a half-plane the inward normal;
/// - the whole plane: the origin and the four axis directions.
class PlaneCell {
 public:
  /// Returns conv + cone of the generators. Requires a point among them, h >= 0 throughout and
  /// no (0, 0, 0). O(n log n).
  static PlaneCell hull(std::vector<HomogeneousPoint> generators);

  /// The vertices in counterclockwise order. Those of an unbounded cell without a line go from
  /// the border that comes from infinity to the one that goes there.
  const std::vector<PlanePoint>& vertices() const { return vertices_; }
  /// The extreme directions. Two directions a, b of a wedge have a to the right.
  const std::vector<PlaneDirection>& rays() const { return rays_; }
  /// The dimension: 0, 1 or 2.
  int dimension() const { return dimension_; }
  bool is_bounded() const { return rays_.empty(); }  ///< whether no direction is in it

  /// The vertices, then the rays: their hull is the cell.
  std::vector<HomogeneousPoint> generators() const;
  /// The border, directed with the cell to its left; a cell of dimension 1 is its own border.
  /// Each line is two rays. A point and the plane have no edges.
  const std::vector<PlaneEdge>& edges() const { return edges_; }
  /// Primitive functions f such that the cell is the set with f.g >= 0 for all of them: the
  /// half-planes to the left of the edges; a thinner cell has some to both sides, and at the
  /// ends.
  std::vector<HomogeneousPoint> sides() const;

  /// Returns true if the point is in the cell or on its border. O(edges) exact operations.
  bool contains(const PlanePoint& point) const;

  /// Returns true if both are the same set of points.
  friend bool operator==(const PlaneCell& a, const PlaneCell& b) {
    return a.vertices_ == b.vertices_ && a.rays_ == b.rays_;
  }
  /// Some total order.
  friend bool operator<(const PlaneCell& a, const PlaneCell& b) {
    return a.vertices_ != b.vertices_ ? a.vertices_ < b.vertices_ : a.rays_ < b.rays_;
  }

 private:
  PlaneCell() = default;
  void set_with_line(const std::vector<HomogeneousPoint>& points, PlaneDirection line,
                     bool half_plane);
  void set_without_line(std::vector<HomogeneousPoint> points, std::vector<PlaneDirection> rays);

  std::vector<PlanePoint> vertices_;
  std::vector<PlaneDirection> rays_;
  std::vector<PlaneEdge> edges_;
  int dimension_ = 0;
};

/// Returns the part of the cell with f.g >= 0, f.g = f_x x + f_y y + f_h; nothing if it is
/// empty.
std::optional<PlaneCell> clip(const PlaneCell& cell, const HomogeneousPoint& f);

/// Returns the part of the cell in [low_x, high_x] x [low_y, high_y], for drawing; it is always
/// bounded. Nothing if it is empty.
std::optional<PlaneCell> clip_to_box(const PlaneCell& cell, const PlanePoint& low,
                                     const PlanePoint& high);

}  // namespace stickslip
