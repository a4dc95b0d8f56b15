// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A region of motions as trees cut it, whatever the contacts: a cone, and the strict functions
/// (certificate/FORMAT.md, section 4).
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "stickslip/equilibrium/proof.hpp"
#include "stickslip/motion/cone.hpp"

namespace stickslip {

/// Whether a contact is closed (v_i >= 0), open (v_i <= 0) or either on a region.
enum class Separation { kClosed, kOpen, kMixed };

/// The signs of a linear function on a region.
struct PlaneSigns {
  bool positive = false;      ///< somewhere
  bool negative = false;      ///< somewhere
  bool zeros_barred = false;  ///< some strict function is 0 wherever it is; of one sign only

  /// The plane has parts of the region strictly on both sides.
  bool cuts() const { return positive && negative; }
};

/// Points x = (d, h, l) with motions d of D coordinates.
class StrictCone {
 public:
  /// Of points().
  static constexpr std::size_t kMostPoints = 1000;
  /// Whether l = 0, or any.
  using Multiples = ConeOf<Row>::Multiples;

  /// {h >= 0}, with h strict; D is `motions`.
  explicit StrictCone(std::size_t motions, Multiples multiples = Multiples::kZero)
      : motions_(motions), cone_(multiples, motions + 2) {}
  /// Keeps plane.x >= 0, = 0 or <= 0; strict: it is not 0 at solutions.
  void cut(const Row& plane, Side side, bool strict = false) {
    if (strict) strict_.push_back(cone_.constraint_count());
    cone_.cut(plane, side);
  }

  /// The parts with plane.x >= 0 and <= 0; in the latter it is strict.
  std::pair<StrictCone, StrictCone> halves(const Row& plane) const;

  /// Keeps the cone over a wall of the body.
  void cut_to_wall(const ConvexBody& body, std::size_t wall);

  std::size_t motions() const { return motions_; }  ///< D
  /// Of which all points are sums of nonnegative multiples: lines both ways, and rays.
  const std::vector<Row>& points() const { return points_; }
  /// More of them than a tree may have where D > 3 (FORMAT.md, section 4): checkers may give
  /// up.
  bool has_too_many_points() const { return motions_ > 3 && points_.size() > kMostPoints; }
  /// As ConeOf::pairs().
  std::size_t pairs() const { return cone_.pairs(); }
  /// Of these, by index: some strict function is 0 on all of them.
  bool bars(const std::vector<std::size_t>& zeros) const;
  /// Of a plane on the region.
  PlaneSigns signs(const Row& plane) const;

 protected:
  /// To be called after cuts: fills points().
  void list_points() { points_ = cone_.directions(); }
  /// The indices of points().
  std::vector<std::size_t> all_points() const {
    std::vector<std::size_t> all(points_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }

 private:
  std::size_t motions_;
  ConeOf<Row> cone_;
  std::vector<ConstraintIndex> strict_{0};  // h is constraint 0
  std::vector<Row> points_;
};

}  // namespace stickslip
