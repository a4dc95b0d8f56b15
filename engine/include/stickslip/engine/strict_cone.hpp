// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Regions of motions as trees cut them, whatever the contacts: a cone and its strict functions
/// (certificate/FORMAT.md, section 4).
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "stickslip/engine/cone.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip {

/// The separation of a contact on a region: closed (v_i >= 0), open (v_i <= 0) or either.
enum class Separation { kClosed, kOpen, kMixed };

/// The signs of a linear function on a region.
struct PlaneSigns {
  bool positive = false;  ///< above 0 somewhere
  bool negative = false;  ///< below 0 somewhere
  /// Whether some strict function is 0 wherever this one is. It is set only for a function of
  /// one sign.
  bool zeros_barred = false;

  /// Returns whether parts of the region are strictly on both sides of the plane.
  bool cuts() const { return positive && negative; }
};

/// A cone of points x = (d, h, l) and its strict functions, which are not 0 at solutions.
/// `Vector` is that of ConeOf.
template <class Vector>
class StrictConeOf {
 public:
  /// The multiples l of a new cone: 0 alone, or any number.
  using Multiples = typename ConeOf<Vector>::Multiples;

  /// Makes the cone {h >= 0}, with h strict, of points of so many coordinates.
  explicit StrictConeOf(Multiples multiples = Multiples::kZero,
                        std::size_t coordinates = kCoordinates<Vector>)
      : cone_(multiples, coordinates) {}

  /// Returns the closure of the region.
  const ConeOf<Vector>& cone() const { return cone_; }
  /// Keeps plane.x >= 0, = 0 or <= 0. If `strict` is set, plane.x is not 0 at solutions.
  void cut(const Vector& plane, Side side, bool strict = false) {
    if (strict) strict_.push_back(cone_.constraint_count());
    cone_.cut(plane, side);
  }
  /// Keeps the cone over a wall of the body.
  void cut_to_wall(const ConvexBody& body, std::size_t wall);
  /// Returns whether some strict function is 0 on all of these rays. Then no solution is a
  /// combination of them and lines alone. `tight(ray)` returns the constraints that are 0 on a
  /// ray.
  template <class Rays, class Tight>
  bool bars(const Rays& rays, const Tight& tight) const {
    return std::any_of(strict_.begin(), strict_.end(), [&](ConstraintIndex strict) {
      return std::all_of(rays.begin(), rays.end(), [&](const auto& ray) {
        const std::vector<ConstraintIndex>& zero = tight(ray);
        return std::binary_search(zero.begin(), zero.end(), strict);
      });
    });
  }
  /// Returns true if no solution lies here.
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

/// A region of motions d of D coordinates, with its generators.
class StrictCone : public StrictConeOf<Row> {
 public:
  /// \{ The most points() that a tree may have: for one body in space, and for more than 6
  /// coordinates.
  static constexpr std::size_t kMostPoints = 1000;
  static constexpr std::size_t kMostPointsOfMany = 4000;
  /// \}

  /// Makes the cone {h >= 0}, with h strict; D is `motions`.
  explicit StrictCone(std::size_t motions, Multiples multiples = Multiples::kZero)
      : StrictConeOf(multiples, motions + 2), motions_(motions) {}

  /// A side of a plane to keep.
  struct StrictSide {
    Side side;    ///< the side
    bool strict;  ///< whether the plane is not 0 at solutions there
  };
  /// Returns the parts on these sides of a plane, as that many cuts would.
  std::vector<StrictCone> parts(const Row& plane, const std::vector<StrictSide>& sides) const;

  std::size_t motions() const { return motions_; }  ///< D
  /// Returns the generators: all points are sums of their nonnegative multiples. They are the
  /// lines, each both ways, and then the rays.
  const std::vector<Row>& points() const { return points_; }
  /// Returns whether there are more points than a tree may have where D > 3
  /// (certificate/FORMAT.md, section 4), so that checkers may give up.
  bool has_too_many_points() const {
    return motions_ > 3 && points_.size() > (motions_ > 6 ? kMostPointsOfMany : kMostPoints);
  }
  /// Returns how many pairs of rays the last cut tested, as ConeOf::pairs() does.
  std::size_t pairs() const { return cone_.pairs(); }
  /// Returns whether some strict function is 0 on all of these points, given by index.
  bool bars(const std::vector<std::size_t>& zeros) const;
  /// Returns for each strict function the indices of the points where it is not 0.
  std::vector<std::vector<std::size_t>> strict_points() const;
  /// Returns the signs of a plane on the region.
  PlaneSigns signs(const Row& plane) const;

 protected:
  /// Fills points(). It has to be called after cuts.
  void list_points() { points_ = cone_.directions(); }
  /// Returns the indices of points().
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
