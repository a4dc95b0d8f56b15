// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Regions of motions as nodes of a tree, and the exact rules of its leaves
/// (certificate/FORMAT.md, sections 4 and 7).
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "stickslip/core/sign.hpp"
#include "stickslip/engine/law.hpp"
#include "stickslip/engine/pull_rule.hpp"
#include "stickslip/engine/strict_cone.hpp"

namespace stickslip {

/// A slip as the format defines it, times a positive factor. If it has fewer than four numbers,
/// the others are 0.
using ExactSlip = IntegerVector<4>;

/// The cone of the slips of a contact on a region.
struct SlipCone {
  bool moves = false;  ///< whether the contact *moves* (certificate/FORMAT.md, section 7)
  bool whole = false;  ///< whether slips in every direction occur
  /// The generators and corners whose slips generate the cone, unless it is whole. There are
  /// none if there is no slip at all.
  std::vector<std::pair<std::size_t, std::size_t>> sides;
  /// The directions of the sides, if the cone has three dimensions.
  std::vector<Double3> units{};
};

/// Returns functions of points that are >= 0 on the simplex around a bound of motions
/// (certificate/FORMAT.md, section 4) and nowhere else.
std::vector<Row> simplex_planes(const RationalRow& bound);

/// A region with what is settled about each contact. Its law must outlive it.
class MotionRegion : public StrictCone {
 public:
  /// Returns the root of a tree: {h >= 0}, within the multiples of a margin and the simplex
  /// around a bound of motions and, under the bilateral law, with v_i >= 0 for each contact
  /// whose v_i is certain.
  static MotionRegion root(const Law& law);
  /// Returns the cone over a wall of a parallelepiped or simplex of motions, by its index
  /// (StrictConeOf::cut_to_wall), with all multiples of a margin, both ends included.
  static MotionRegion wall(const Law& law, const ConvexBody& body, std::size_t wall);

  /// Returns the parts where the plane is >= 0 and where it is < 0.
  std::vector<MotionRegion> halves(const Row& plane) const;
  /// Returns the children of a split by a contact's slip: in the plane those where it slips one
  /// way, sticks, and slips the other way; else those where it sticks and where it slips.
  std::vector<MotionRegion> slip_children(std::size_t contact) const;

  /// Returns points(), the extreme rays of the cone, in doubles, in the law's units, with
  /// norm 1.
  const std::vector<Reals>& generators() const { return generators_; }
  /// Returns whether the contact is closed, open or either on the region.
  Separation separation(std::size_t contact) const { return separations_[contact]; }
  /// Returns the slips of a contact that is not open.
  const SlipCone& slips(std::size_t contact) const { return slips_[contact]; }
  /// Returns the sign of all slips of a contact in the plane; nothing if they have no common
  /// sign.
  std::optional<Sign> slip_sign(std::size_t contact) const;
  /// Returns the extreme ratios of friction along T to the normal coefficient that a contact in
  /// the plane may have, given the ends of mu: friction is against the slip.
  template <class Number>
  std::vector<Number> slopes(std::size_t contact, const std::array<Number, 2>& mu) const;
  /// Returns whether a slip split into two has said that the contact slips. (In the plane,
  /// where a split has three children, a strict function of the cone says so.)
  bool is_strict(std::size_t contact) const { return strict_slips_[contact] != 0; }
  /// Returns whether a slip split has said that the contact sticks.
  bool is_still(std::size_t contact) const { return still_[contact] != 0; }
  /// Returns true only if it is proved that no solution is a multiple of this generator.
  bool bars_point(std::size_t generator) const { return bars_all({generator}); }
  /// Returns true only if it is proved that no solution lies here, or none within the bound of
  /// motions.
  bool is_barred() const { return barred_; }
  /// Returns the plane d_j = B_j h or d_j = -B_j h that the point exceeds the most, with the
  /// point on its negative side. Returns nothing if the point is within the bound, or if that
  /// plane does not cut the region.
  std::optional<Row> bound_across(const Reals& point) const;
  /// \{ Returns the largest, or the least, v of a contact at a generator, in doubles; exactly 0
  /// where it is 0.
  double most_separation(std::size_t contact, std::size_t generator) const {
    return most_separations(contact)[generator];
  }
  double least_separation(std::size_t contact, std::size_t generator) const {
    return least_separations(contact)[generator];
  }
  /// \}
  /// \{ Returns the same at all generators.
  const double* most_separations(std::size_t contact) const {
    return high_.data() + contact * generators_.size();
  }
  const double* least_separations(std::size_t contact) const {
    return low_.data() + contact * generators_.size();
  }
  /// \}
  /// Returns the slip s at a generator and a corner of the geometry, in doubles; exactly 0
  /// where it is 0.
  const Double3& slip(std::size_t contact, std::size_t generator, std::size_t corner) const {
    return slip_values_[first_[contact] + generator * law_->contacts[contact].corners.size() +
                        corner];
  }
  /// Returns N.d at a generator by corner, in doubles; exactly 0 where it is 0. Requires a
  /// contact with LawContact::whole.
  const double* rises(std::size_t contact, std::size_t generator) const {
    return &rises_[first_[contact] + generator * law_->contacts[contact].corners.size()];
  }
  /// Returns whether the virtual twist y proves, exactly, that no solution lies here: by the
  /// rule `leaf-bound` of the format and, if there is a pull, `leaf-direction`.
  bool is_refuted(const Row& y, const PullRule* pull) const;
  /// Returns whether a twist that moves proves the same: by `moving-list`, `leaf-bound` and
  /// `leaf-direction`. Requires that the law is no margin and has no hull of loads. O(rays^2
  /// contacts), and for each ray and contact a root at each corner of the geometry where
  /// doubles do not tell.
  bool is_refuted(const MovingLeaf& leaf, const PullRule* pull) const;

 private:
  MotionRegion(const Law& law, StrictCone cone, bool is_of_wall = false);
  /// Makes a part of a region, without what update() finds.
  MotionRegion(const MotionRegion& parent, StrictCone cone);
  std::vector<MotionRegion> children(const Row& plane,
                                     const std::vector<StrictSide>& sides) const;
  static StrictCone whole_family(const Law& law);
  void update();
  bool is_beyond() const;
  void classify();  ///< finds slips, unless the region is barred
  void find_separation(std::size_t contact);
  void compute_slips(std::size_t contact);
  void compute_rises(std::size_t contact);
  void find_slips(std::size_t contact);
  void find_sign(SlipCone& cone, std::size_t contact) const;
  void find_sides(SlipCone& cone, std::size_t contact) const;
  void find_solid(SlipCone& cone, std::size_t contact) const;
  /// Returns whether StrictCone::bars() does, or whether a strict slip is 0 on all of them.
  bool bars_all(const std::vector<std::size_t>& zeros) const;
  Rational most_work(std::size_t contact, const Row& y) const;
  ExactSlip exact_slip(std::size_t contact, std::size_t generator, std::size_t corner) const;
  const std::vector<ExactSlip>& exact_sides(std::size_t contact) const;

  const Law* law_;
  bool is_of_wall_;
  std::vector<char> strict_slips_;  ///< whether a split said that a contact slips
  std::vector<char> still_;         ///< whether a split said that its s is 0 everywhere
  std::vector<Separation> separations_;
  std::vector<SlipCone> slips_;
  /// The exact slips of `sides`, by contact; empty until they are first asked for.
  mutable std::vector<std::vector<ExactSlip>> exact_sides_;
  std::vector<Reals> generators_;
  std::vector<double> high_;  ///< the largest v, by contact and generator
  std::vector<double> low_;
  /// The index of the first entry of a contact in the next two members, in which generators and
  /// corners follow.
  std::vector<std::size_t> first_;
  std::vector<Double3> slip_values_;
  std::vector<double> rises_;
  bool barred_ = false;
};

template <class Number>
std::vector<Number> MotionRegion::slopes(std::size_t contact,
                                         const std::array<Number, 2>& mu) const {
  std::vector<Number> result{Number(-mu[1]), mu[1]};
  if (const std::optional<Sign> sign = slip_sign(contact)) {
    if (*sign == Sign::kPositive) {
      result = {Number(-mu[0]), Number(-mu[1])};
    } else {
      result = {mu[0], mu[1]};
    }
  }
  if (result[0] == result[1]) result.pop_back();
  return result;
}

}  // namespace stickslip
