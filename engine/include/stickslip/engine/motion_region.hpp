// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A region of motions as a node of a tree sees it, and the rules of its leaves
/// (certificate/FORMAT.md, sections 4 and 7), exactly.
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

/// A slip of the format, times a factor; of fewer numbers the others are 0.
using ExactSlip = IntegerVector<4>;

/// The slips of a contact on a region.
struct SlipCone {
  bool moves = false;  ///< as the format says
  bool whole = false;  ///< any direction
  /// Generators and corners whose slips generate the same cone, unless it is whole: none if
  /// there is no slip at all.
  std::vector<std::pair<std::size_t, std::size_t>> sides;
  std::vector<Double3> units{};  ///< of a cone in three dimensions: the directions of the sides
};

/// Returns functions of points that are >= 0 on the simplex around a bound of motions
/// (certificate/FORMAT.md, section 4) and nowhere else.
std::vector<Row> simplex_planes(const RationalRow& bound);

/// The region with what is settled about each contact. Its law must outlive it.
class MotionRegion : public StrictCone {
 public:
  /// {h >= 0}, of a margin its multiples, and under the bilateral law v_i >= 0 where that is
  /// certain.
  static MotionRegion root(const Law& law);
  /// As StrictCone::cut_to_wall.
  static MotionRegion wall(const Law& law, const ConvexBody& body, std::size_t wall);

  /// The two parts of a cut; the strict side of a plane is the negative one.
  std::vector<MotionRegion> halves(const Row& plane) const;
  /// The children of a slip split.
  std::vector<MotionRegion> slip_children(std::size_t contact) const;

  /// points() in doubles.
  const std::vector<Reals>& generators() const { return generators_; }
  /// Whether the contact is closed, open or either.
  Separation separation(std::size_t contact) const { return separations_[contact]; }
  /// Of a contact that is not open.
  const SlipCone& slips(std::size_t contact) const { return slips_[contact]; }
  /// Of a contact in the plane: the sign of all its slips, if they have one.
  std::optional<Sign> slip_sign(std::size_t contact) const;
  /// Slopes of friction, by the ends of mu, that a contact in the plane may have.
  template <class Number>
  std::vector<Number> slopes(std::size_t contact, const std::array<Number, 2>& mu) const;
  /// Whether a slip split has said that the contact slips.
  bool is_strict(std::size_t contact) const { return strict_slips_[contact] != 0; }
  /// Whether one has said that it sticks.
  bool is_still(std::size_t contact) const { return still_[contact] != 0; }
  /// No solution is a multiple of this generator.
  bool bars_point(std::size_t generator) const { return bars_all({generator}); }
  /// No solution lies here, or none within the bound of motions.
  bool is_barred() const { return barred_; }
  /// A plane beyond which, on its strict side, no motion is within the bound, as that of this
  /// point is not; nothing if that is, or if none cuts here.
  std::optional<Row> bound_across(const Reals& point) const;
  /// \{ The largest v of a contact at a generator, and the least, in doubles, 0 where it is 0.
  double most_separation(std::size_t contact, std::size_t generator) const {
    return high_[contact * generators_.size() + generator];
  }
  double least_separation(std::size_t contact, std::size_t generator) const {
    return low_[contact * generators_.size() + generator];
  }
  /// \}
  /// s in doubles; 0 where it is 0.
  const Double3& slip(std::size_t contact, std::size_t generator, std::size_t corner) const {
    return slip_values_[first_[contact] + generator * law_->contacts[contact].corners.size() +
                        corner];
  }
  /// N.d by corner, in doubles, 0 where it is 0; of contacts with LawContact::whole.
  const double* rises(std::size_t contact, std::size_t generator) const {
    return &rises_[first_[contact] + generator * law_->contacts[contact].corners.size()];
  }
  /// `leaf-bound`, and `leaf-direction` if there is a pull.
  bool is_refuted(const Row& y, const PullRule* pull) const;

 private:
  MotionRegion(const Law& law, StrictCone cone, bool is_of_wall = false);
  static StrictCone whole_family(const Law& law);
  void update();
  bool is_beyond() const;
  void classify();  ///< by the strict functions
  void find_separation(std::size_t contact);
  void compute_slips(std::size_t contact);
  void compute_rises(std::size_t contact);
  void find_slips(std::size_t contact);
  void find_sign(SlipCone& cone, std::size_t contact) const;
  void find_sides(SlipCone& cone, std::size_t contact) const;
  void find_solid(SlipCone& cone, std::size_t contact) const;
  /// StrictCone::bars, or a strict slip is 0 on all of them.
  bool bars_all(const std::vector<std::size_t>& zeros) const;
  Rational most_work(std::size_t contact, const Row& y) const;
  ExactSlip exact_slip(std::size_t contact, std::size_t generator, std::size_t corner) const;
  const std::vector<ExactSlip>& exact_sides(std::size_t contact) const;

  const Law* law_;
  bool is_of_wall_;
  std::vector<char> strict_slips_;  ///< by contact
  std::vector<char> still_;         ///< by contact: s is 0 everywhere
  std::vector<Separation> separations_;
  std::vector<SlipCone> slips_;
  mutable std::vector<std::vector<ExactSlip>> exact_sides_;  ///< by contact; empty: not yet
  std::vector<Reals> generators_;
  std::vector<double> high_;  ///< by contact and generator, as low_
  std::vector<double> low_;
  std::vector<std::size_t> first_;  ///< of a contact, by generator and corner:
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
