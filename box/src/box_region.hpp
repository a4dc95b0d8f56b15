// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A region of motions as a node of a tree about a box sees it, and the rules of its leaves
/// (certificate/FORMAT.md, section 6), exactly.
#pragma once

#include <optional>
#include <vector>

#include "box_model.hpp"
#include "stickslip/box/box_verdict.hpp"
#include "stickslip/equilibrium/search/cone.hpp"

namespace stickslip::box_detail {

/// What `leaf-direction` asks of list 2: y.A(d - h d0) >= 0.
struct Direction {
  Matrix3 matrix;  ///< A
  Twist twist;     ///< d0

  /// The coefficients of y.A(d - h d0) in (d, h), up to a positive factor.
  IntegerVector5 form(const IntegerVector3& y) const;
};

class BoxRegion {
 public:
  /// {h >= 0}, and under the bilateral law v_i >= 0 where that is certain.
  static BoxRegion root(const BoxModel& model);
  /// The cone over a wall of {d : |E_j.(d - d0)| <= 1}: E_wall.(d - d0) = sign.
  static BoxRegion wall(const BoxModel& model, const Matrix3& walls, const Twist& twist,
                        std::size_t wall, int sign);

  /// The part with plane.x >= 0, = 0 or <= 0; strict: the plane is not 0 at solutions.
  BoxRegion child(const BoxModel& model, const IntegerVector5& plane, Side side,
                  bool strict) const;

  /// Generators; lines both ways.
  const std::vector<IntegerVector5>& points() const { return points_; }
  Separation separation(std::size_t contact) const { return separations_[contact]; }
  /// The sign of slip that all solutions have; kZero for none.
  Sign slip(std::size_t contact) const { return slips_[contact]; }
  bool is_barred() const;

  /// The signs of a plane on the region, and whether its zeros are barred.
  struct Signs {
    bool positive = false;
    bool negative = false;
    bool zeros_barred = false;
  };
  Signs signs(const IntegerVector5& plane) const;

  /// `leaf-bound`, and `leaf-direction` if there is a direction.
  bool is_refuted(const BoxModel& model, const IntegerVector3& y,
                  const Direction* direction) const;

 private:
  explicit BoxRegion(std::size_t contacts)
      : separations_(contacts, Separation::kMixed), slips_(contacts, Sign::kZero) {}
  void update(const BoxModel& model);
  bool bars(const std::vector<std::size_t>& zeros) const;

  Cone cone_;
  std::vector<ConstraintIndex> strict_{0};  ///< h is constraint 0
  std::vector<IntegerVector5> points_;
  std::vector<Separation> separations_;
  std::vector<Sign> slips_;
};

}  // namespace stickslip::box_detail
