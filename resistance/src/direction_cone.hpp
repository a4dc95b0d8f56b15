// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The directions in which a cell of a plane is unbounded.
#pragma once

#include "stickslip/resistance/plane_cell.hpp"

namespace stickslip {

inline Integer cross(const PlaneDirection& a, const PlaneDirection& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// A closed convex cone of directions, grown by one direction at a time. `right` and `left` are
/// its extreme directions; of a line its two directions, of a half-plane the border's, with the
/// half-plane to the left of `right`.
struct DirectionCone {
  enum class Shape { kNone, kRay, kWedge, kLine, kHalfPlane, kPlane };
  Shape shape = Shape::kNone;
  PlaneDirection right{};
  PlaneDirection left{};

  void set_line(Shape line_or_half_plane, const PlaneDirection& direction) {
    shape = line_or_half_plane;
    right = direction;
    left = negated(direction);
  }

  void add(const PlaneDirection& r) {
    const int from_right = cross(right, r).sign();
    const int from_left = cross(left, r).sign();
    switch (shape) {
      case Shape::kNone:
        shape = Shape::kRay;
        right = left = r;
        break;
      case Shape::kRay:
        if (from_right == 0) {
          if (dot(right, r).sign() < 0) set_line(Shape::kLine, right);
        } else {
          shape = Shape::kWedge;
          (from_right > 0 ? left : right) = r;
        }
        break;
      case Shape::kWedge:
        if (from_right >= 0 && from_left <= 0) break;
        if (from_right == 0) {
          set_line(Shape::kHalfPlane, right);
        } else if (from_left == 0) {
          set_line(Shape::kHalfPlane, r);
        } else if (from_right < 0 && from_left > 0) {
          shape = Shape::kPlane;
        } else {
          (from_right > 0 ? left : right) = r;
        }
        break;
      case Shape::kLine:
        if (from_right != 0) set_line(Shape::kHalfPlane, from_right > 0 ? right : left);
        break;
      case Shape::kHalfPlane:
        if (from_right < 0) shape = Shape::kPlane;
        break;
      case Shape::kPlane:
        break;
    }
  }
};

}  // namespace stickslip
