// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Convex cells of a plane of loads as a tree cuts them, open at some of their borders.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "stickslip/measures/plane_cell.hpp"

namespace stickslip::resistance_detail {

/// A linear function of homogeneous points (s, t, h).
using LoadFunction = HomogeneousPoint;

/// The signs of a linear function on a convex set of loads.
struct LoadSigns {
  bool negative = false;  ///< on some generator
  bool zero = false;      ///< on some generator
  bool positive = false;  ///< on some generator

  bool are_mixed() const { return negative && positive; }
};

/// A convex polyhedron in the plane, with its generators and sides, which are needed again and
/// again.
struct ConvexLoads {
  explicit ConvexLoads(PlaneCell cell);

  PlaneCell cell;
  std::vector<HomogeneousPoint> generators;
  std::vector<LoadFunction> sides;  ///< the polyhedron is where all of these are >= 0

  LoadSigns signs(const LoadFunction& f) const;
  /// Returns true if this is within the other; both are closed.
  bool is_within(const ConvexLoads& other) const;
};

/// A closed convex set without the points at which any of some functions, nonnegative on it, is
/// 0.
class LoadCell {
 public:
  /// The whole plane.
  LoadCell();

  const ConvexLoads& closure() const { return closure_; }
  /// The strict functions that are 0 somewhere on the closure: they make the cell smaller than
  /// that.
  const std::vector<LoadFunction>& strict() const { return strict_; }

  /// Returns the part with f >= 0, or strictly f > 0; nothing if that part has no point.
  std::optional<LoadCell> part(const LoadFunction& f, bool strictly) const;
  /// Returns true if the cell has a point of the other set, which is closed.
  bool meets(const ConvexLoads& other) const;

 private:
  LoadCell(ConvexLoads closure, std::vector<LoadFunction> strict)
      : closure_(std::move(closure)), strict_(std::move(strict)) {}

  ConvexLoads closure_;
  std::vector<LoadFunction> strict_;
};

}  // namespace stickslip::resistance_detail
