// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Cells of a plane of loads as a tree cuts them: convex, and open at some of their borders.
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

/// A convex polyhedron in the plane, with what is needed of it again and again.
struct ConvexLoads {
  explicit ConvexLoads(PlaneCell cell);

  PlaneCell cell;
  std::vector<HomogeneousPoint> generators;
  std::vector<LoadFunction> sides;  ///< it is where all of these are >= 0

  LoadSigns signs(const LoadFunction& f) const;
  /// As closed sets.
  bool is_within(const ConvexLoads& other) const;
};

/// The points of a closed convex set where some functions, nonnegative on it, are not 0.
class LoadCell {
 public:
  /// The whole plane.
  LoadCell();

  const ConvexLoads& closure() const { return closure_; }
  /// Of those that make it smaller than its closure, the ones that are 0 somewhere on that.
  const std::vector<LoadFunction>& strict() const { return strict_; }

  /// The part with f >= 0, or strictly f > 0; nothing if that has no point.
  std::optional<LoadCell> part(const LoadFunction& f, bool strictly) const;
  /// Whether it has a point of the other set, which is closed.
  bool meets(const ConvexLoads& other) const;

 private:
  LoadCell(ConvexLoads closure, std::vector<LoadFunction> strict)
      : closure_(std::move(closure)), strict_(std::move(strict)) {}

  ConvexLoads closure_;
  std::vector<LoadFunction> strict_;
};

}  // namespace stickslip::resistance_detail
