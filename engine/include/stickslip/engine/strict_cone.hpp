// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A region of motions as trees cut it, whatever the contacts: a cone, and the strict functions
/// (certificate/FORMAT.md, section 4).
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "stickslip/engine/cone.hpp"
#include "stickslip/engine/proof.hpp"

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

/// A cone of points x = (d, h, l) and its strict functions. A Vector as of ConeOf.
template <class Vector>
class StrictConeOf {
 public:
  /// Whether l = 0, or any.
  using Multiples = typename ConeOf<Vector>::Multiples;

  /// {h >= 0}, with h strict; of so many coordinates of points.
  explicit StrictConeOf(Multiples multiples = Multiples::kZero,
                        std::size_t coordinates = kCoordinates<Vector>)
      : cone_(multiples, coordinates) {}

  /// Its closure.
  const ConeOf<Vector>& cone() const { return cone_; }
  /// Keeps plane.x >= 0, = 0 or <= 0; strict: it is not 0 at solutions.
  void cut(const Vector& plane, Side side, bool strict = false) {
    if (strict) strict_.push_back(cone_.constraint_count());
    cone_.cut(plane, side);
  }
  /// Keeps the cone over a wall of the body.
  void cut_to_wall(const ConvexBody& body, std::size_t wall);
  /// Whether some strict function is 0 on all of these rays: no solution is a combination of
  /// them and lines alone. `tight(ray)` has the constraints that are 0 on it.
  template <class Rays, class Tight>
  bool bars(const Rays& rays, const Tight& tight) const {
    return std::any_of(strict_.begin(), strict_.end(), [&](ConstraintIndex strict) {
      return std::all_of(rays.begin(), rays.end(), [&](const auto& ray) {
        const std::vector<ConstraintIndex>& zero = tight(ray);
        return std::binary_search(zero.begin(), zero.end(), strict);
      });
    });
  }
  /// No solution lies here.
  bool is_barred() const {
    return bars(
        cone_.rays(), [](const auto& ray) -> const auto& { return ray.tight; });
  }

 protected:
  ConeOf<Vector> cone_;                     ///< cut as it may be
  std::vector<ConstraintIndex> strict_{0};  ///< increasing; h is constraint 0
};

extern template class StrictConeOf<IntegerVector5>;
extern template class StrictConeOf<Row>;

/// With motions d of D coordinates, and its generators.
class StrictCone : public StrictConeOf<Row> {
 public:
  /// \{ Of points(): of one body in space, and of more coordinates.
  static constexpr std::size_t kMostPoints = 1000;
  static constexpr std::size_t kMostPointsOfMany = 4000;
  /// \}

  /// {h >= 0}, with h strict; D is `motions`.
  explicit StrictCone(std::size_t motions, Multiples multiples = Multiples::kZero)
      : StrictConeOf(multiples, motions + 2), motions_(motions) {}

  /// The parts with plane.x >= 0 and <= 0; in the latter it is strict.
  std::pair<StrictCone, StrictCone> halves(const Row& plane) const;

  std::size_t motions() const { return motions_; }  ///< D
  /// Of which all points are sums of nonnegative multiples: lines both ways, and rays.
  const std::vector<Row>& points() const { return points_; }
  /// More of them than a tree may have where D > 3 (FORMAT.md, section 4): checkers may give
  /// up.
  bool has_too_many_points() const {
    return motions_ > 3 && points_.size() > (motions_ > 6 ? kMostPointsOfMany : kMostPoints);
  }
  /// As ConeOf::pairs().
  std::size_t pairs() const { return cone_.pairs(); }
  /// Of points, by index: some strict function is 0 on all of them.
  bool bars(const std::vector<std::size_t>& zeros) const;
  /// Of each strict function the points where it is not 0, by index.
  std::vector<std::vector<std::size_t>> strict_points() const;
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
  std::vector<Row> points_;
};

}  // namespace stickslip
