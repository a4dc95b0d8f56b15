// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A region of motions as a node of a tree about a box sees it, and the rules of its leaves
/// (certificate/FORMAT.md, section 6), exactly.
#pragma once

#include <vector>

#include "box_model.hpp"
#include "stickslip/box/box_verdict.hpp"

namespace stickslip::box_detail {

class BoxRegion : public StrictCone<3> {
 public:
  /// {h >= 0}, and under the bilateral law v_i >= 0 where that is certain.
  static BoxRegion root(const BoxModel& model);
  /// As StrictCone::cut_to_wall.
  static BoxRegion wall(const BoxModel& model, const ConvexBody<3>& body, std::size_t wall);

  /// The part with plane.x >= 0, = 0 or <= 0; strict: the plane is not 0 at solutions.
  BoxRegion child(const BoxModel& model, const IntegerVector5& plane, Side side,
                  bool strict) const;

  Separation separation(std::size_t contact) const { return separations_[contact]; }
  /// The sign of slip that all solutions have; kZero for none.
  Sign slip(std::size_t contact) const { return slips_[contact]; }
  bool is_barred() const { return bars(all_points()); }

  /// `leaf-bound`, and `leaf-direction` if there is a direction.
  bool is_refuted(const BoxModel& model, const IntegerVector3& y,
                  const Direction<3>* direction) const;

 private:
  BoxRegion(const BoxModel& model, StrictCone cone);
  void update(const BoxModel& model);

  std::vector<Separation> separations_;
  std::vector<Sign> slips_;
};

}  // namespace stickslip::box_detail
