// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The search for proofs by degree (certificate/FORMAT.md, section 6, and "Segments by degree"
/// of section 5), of one grasp in exact numbers or of the members of a family: a
/// parallelepiped of motions K that holds an equilibrium, and moves with the multiple. What it
/// takes is digits of the contacts' own numbers, however long the equilibria themselves would
/// be.
///
/// **Method.** Equilibria are followed in doubles (smooth_balance.hpp). K goes in a straight
/// line from one of them to another and is |J e| <= rho by coordinates: J is how forces answer
/// motions half-way, with friction made smooth over the slips that K has, so that on a wall a
/// force of about rho is left over, whatever friction does that K leaves open. The trees of the
/// walls are sought for one rho after another. Then, for one grasp, K is what keeps the mode of
/// an equilibrium (mode_balance.hpp): there little is left to decide, however many contacts
/// would slip otherwise or open close by.
#pragma once

#include <optional>

#include "search/smooth_balance.hpp"
#include "stickslip/equilibrium/margin.hpp"
#include "stickslip/equilibrium/stable_by_degree.hpp"

namespace stickslip::equilibrium_detail {

class DegreeSearch {
 public:
  using Motion = Eigen::Vector3d;

  /// One grasp, or a family for all l >= 0, which has to outlive this.
  explicit DegreeSearch(const Problem& problem);

  /// What all proofs took.
  const DegreeWork& work() const { return work_; }

  /// Whether proofs are worth trying.
  bool is_possible() const { return model_.is_moderate && model_.stiffness > 0; }
  /// What acts on the member with h and l, more or less; 1 and 0 are those of one grasp.
  double force_of(double h, double l) const;
  /// An equilibrium of the member with h and l, in doubles: with friction less and less smooth,
  /// as far as that goes; from another one if there is one near.
  std::optional<Motion> settle(double h, double l, const Motion* near);

  /// That one grasp is stable: `end_twist` means nothing.
  std::optional<SegmentByDegree> prove_one();
  /// That all multiples of a range are resisted, between equilibria at its ends; of a short one
  /// with more patience.
  std::optional<SegmentByDegree> prove_segment(const MarginInterval& range, const Motion& from,
                                               const Motion& to, bool is_short);

 private:
  Motion sprung(double h, double l) const;
  std::optional<SegmentByDegree> prove_around(const Motion& there,
                                              const std::optional<MarginInterval>& range,
                                              const Motion& from, const Motion& to,
                                              std::size_t tries);
  std::optional<SegmentByDegree> prove_with(const std::optional<MarginInterval>& range,
                                            SegmentByDegree shape);

  const Problem& problem_;
  DegreeWork work_;
  DoubleModel model_;
  SmoothBalance balance_;
  std::size_t last_size_ = 0;  ///< of K, that served
};

}  // namespace stickslip::equilibrium_detail
