// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The search for segments by degree (certificate/FORMAT.md, section 5), of the members of a
/// family: a parallelepiped of motions K that holds an equilibrium, and moves with the
/// multiple. What it takes is digits of the contacts' own numbers, however long the equilibria
/// themselves would be.
///
/// **Method.** Equilibria are followed in doubles (smooth_balance.hpp). K goes in a straight
/// line from one of them to another and is |J e| <= rho by coordinates: J is how forces answer
/// motions half-way, with friction made smooth over the slips that K has, so that on a wall a
/// force of about rho is left over, whatever friction does that K leaves open. The trees of the
/// walls are sought for one rho after another.
#pragma once

#include <optional>

#include "engine/planar/crowd_walls.hpp"
#include "engine/planar/smooth_balance.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip::margin_detail {

/// What it took; reproducible.
struct DegreeWork {
  std::size_t proofs = 0;  ///< parallelepipeds tried
  ConeWork cone;           ///< of the trees of their walls
};

class SegmentSearch {
 public:
  using Motion = Eigen::Vector3d;

  /// A family for all l >= 0, which has to outlive this.
  explicit SegmentSearch(const Problem& problem);

  /// What all proofs took.
  DegreeWork work() const { return {proofs_, crowd_.work()}; }

  /// Whether proofs are worth trying.
  bool is_possible() const { return model_.is_moderate && model_.stiffness > 0; }
  /// What acts on the member with h and l, more or less.
  double force_of(double h, double l) const;
  /// An equilibrium of the member with h and l, in doubles: with friction less and less smooth,
  /// as far as that goes; from another one if there is one near.
  std::optional<Motion> settle(double h, double l, const Motion* near);

  /// That all multiples of a range are resisted, between equilibria at its ends; of a short one
  /// with more patience.
  std::optional<SegmentByDegree> prove_segment(const MarginInterval& range, const Motion& from,
                                               const Motion& to, bool is_short);

 private:
  Motion sprung(double h, double l) const;
  std::optional<SegmentByDegree> prove_around(const Motion& there, const MarginInterval& range,
                                              const Motion& from, const Motion& to,
                                              std::size_t tries);
  std::optional<SegmentByDegree> prove_with(const MarginInterval& range, SegmentByDegree shape);

  const Problem& problem_;
  CrowdWalls crowd_;
  const DoubleModel& model_;
  std::size_t proofs_ = 0;
  SmoothBalance balance_;
  std::size_t last_size_ = 0;  ///< of K, that served
};

}  // namespace stickslip::margin_detail
