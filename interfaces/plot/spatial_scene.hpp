// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Bodies and contacts in space as they are seen along an axis; those of the plane are seen
/// from above.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "grasp_scene.hpp"
#include "stickslip/core/box.hpp"

namespace stickslip::plot_detail {

/// A place or a direction in scene coordinates.
using InkVector = std::array<double, 3>;

InkVector sum(InkVector a, double factor, const InkVector& b);
/// Returns the largest entry.
Rational size_of(const Vector3& v);
/// Returns each component over size > 0.
InkVector over_size(const Vector3& v, const Rational& size);

/// The direction from which the scene is looked at.
struct LineOfSight {
  const char* heading;
  std::size_t right;  ///< the axis of the object frame that points right
  std::size_t up;     ///< the axis of the object frame that points up
  std::size_t towards;
  int sign;  ///< the sign of the axis `towards` that points at the eye

  InkPoint operator()(const InkVector& v) const { return {v[right], v[up]}; }
};

/// Returns the three views of space, or the one of the plane.
std::vector<LineOfSight> sides_of(bool in_space);

struct SpatialContactInk {
  Vector3 position;  ///< the exact place in the object frame
  InkVector at;
  InkVector normal;  ///< of length 1, as are the two that span the tangent plane
  InkVector across;
  InkVector along;
};

SpatialContactInk spatial_contact_ink(const Vector3& position, const InkVector& at,
                                      const Vector3& normal);

/// Returns points whose hull is the part in the contact's cone of a ball around the contact.
std::vector<InkVector> cone_around(const SpatialContactInk& contact, double half_angle,
                                   double size);

/// The look of a body.
struct Shape {
  enum class Kind { kHull, kRings, kFaces };

  Kind kind = Kind::kHull;                        ///< the meaning of `parts`
  std::vector<InkVector> points{};                ///< none: nothing is seen
  std::vector<std::vector<std::size_t>> parts{};  ///< lists of indices of points; none for a
                                                  ///< hull

  /// Returns the region that its rings are around.
  RingsAround within() const {
    return kind == Kind::kFaces ? RingsAround::kAnyWinding : RingsAround::kOddTimes;
  }
  std::vector<std::vector<InkPoint>> seen(const LineOfSight& side) const;
  /// Returns the mean of its points; the origin without any.
  InkVector middle() const;
};

std::vector<InkPoint> hull_seen(const LineOfSight& side, const std::vector<InkVector>& points);

/// Returns a sketch of a body that nobody gave: the hull of the contacts, whose normals point
/// into it, and of points a little inside of them that are behind no contact.
Shape sketch(const std::vector<SpatialContactInk>& contacts, bool in_space);
/// Returns a sketch of a link: the hull of the surroundings of these points.
Shape sketch_of_link(const std::vector<InkVector>& points, bool in_space);

}  // namespace stickslip::plot_detail
