// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A region of motions as a node of a tree in space sees it, and the rules of its leaves
/// (certificate/FORMAT.md, section 7), exactly.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "space_model.hpp"
#include "stickslip/equilibrium/search/scaled_point.hpp"
#include "stickslip/equilibrium/search/strict_cone.hpp"
#include "stickslip/space/spatial_verdict.hpp"

namespace stickslip::space_detail {

using equilibrium_detail::ScaledPoint;

/// The slips of a contact on a region.
struct SlipCone {
  bool moves = false;  ///< as the format says
  bool whole = false;  ///< any direction across n
  /// Generators and corners whose slips generate the same cone, unless it is whole: none if
  /// there is no slip at all.
  std::vector<std::pair<std::size_t, std::size_t>> sides;
};

class SpaceRegion : public StrictCone<6> {
 public:
  /// {h >= 0}, and under the bilateral law v_i >= 0 where that is certain.
  static SpaceRegion root(const SpaceModel& model);
  /// As StrictCone::cut_to_wall.
  static SpaceRegion wall(const SpaceModel& model, const ConvexBody<6>& body, std::size_t wall);

  /// \{ Children. The strict side of a plane is the negative one.
  std::vector<SpaceRegion> halves(const SpaceModel& model, const Point& plane) const;
  SpaceRegion sticking(const SpaceModel& model, std::size_t contact) const;
  SpaceRegion slipping(const SpaceModel& model, std::size_t contact) const;
  /// \}

  /// points() in doubles.
  const std::vector<ScaledPoint<6>>& generators() const { return generators_; }
  Separation separation(std::size_t contact) const { return separations_[contact]; }
  const SlipCone& slips(std::size_t contact) const { return slips_[contact]; }
  /// Whether a slip split has said that the contact slips.
  bool is_strict(std::size_t contact) const { return strict_slips_[contact] != 0; }
  /// Whether one has said that it sticks.
  bool is_still(std::size_t contact) const { return still_[contact] != 0; }
  /// No solution is a multiple of this generator.
  bool bars_point(const SpaceModel& model, std::size_t generator) const {
    return bars_all(model, {generator});
  }
  /// No solution lies here.
  bool is_barred() const { return barred_; }
  /// The largest v of a contact at a generator, and the least, in doubles, 0 where it is 0.
  double most_separation(std::size_t contact, std::size_t generator) const {
    return high_[contact * generators_.size() + generator];
  }
  double least_separation(std::size_t contact, std::size_t generator) const {
    return low_[contact * generators_.size() + generator];
  }
  /// s in doubles; 0 where it is 0.
  const Double3& slip(const SpaceModel& model, std::size_t contact, std::size_t generator,
                      std::size_t corner) const {
    return slip_values_[first_slip_[contact] +
                        generator * model.contacts[contact].corners.size() + corner];
  }
  /// `leaf-bound`, and `leaf-direction` if there is a direction.
  bool is_refuted(const SpaceModel& model, const IntegerVector<6>& y,
                  const Direction<6>* direction) const;

 private:
  SpaceRegion(const SpaceModel& model, StrictCone cone);
  void update(const SpaceModel& model);
  void classify(const SpaceModel& model);  ///< by the strict functions
  void find_separation(const SpaceModel& model, std::size_t contact);
  void compute_slips(const SpaceModel& model, std::size_t contact);
  void find_slips(const SpaceModel& model, std::size_t contact);
  /// StrictCone::bars, or a strict slip is 0 on all of them.
  bool bars_all(const SpaceModel& model, const std::vector<std::size_t>& zeros) const;
  Rational most_work(const SpaceModel& model, std::size_t contact,
                     const IntegerVector<6>& y) const;

  std::vector<char> strict_slips_;  ///< by contact
  std::vector<char> still_;         ///< by contact: s is 0 everywhere
  std::vector<Separation> separations_;
  std::vector<SlipCone> slips_;
  std::vector<ScaledPoint<6>> generators_;
  std::vector<double> high_;  ///< by contact and generator, as low_
  std::vector<double> low_;
  std::vector<std::size_t> first_slip_;
  std::vector<Double3> slip_values_;  ///< by contact, generator and corner
  bool barred_ = false;
};

}  // namespace stickslip::space_detail
