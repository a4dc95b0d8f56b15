// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The search for segments by degree (certificate/FORMAT.md, section 5): a parallelepiped of
/// motions K that moves with the multiple of a family and holds an equilibrium of each member.
/// The numbers of such a proof have about as many digits as those of the contacts, however long
/// the equilibria would be.
///
/// **Method.** Equilibria are followed in doubles (smooth_balance.hpp). K goes in a straight
/// line from one of them to another and is |J e| <= rho by coordinates. J is how forces answer
/// motions half-way, with friction made smooth over the slips that K has. So on a wall a force
/// of about rho is left over, whatever the friction that K leaves open does. The trees of the
/// walls are sought for one rho after another.
#pragma once

#include <optional>

#include "engine/planar/crowd_walls.hpp"
#include "engine/planar/smooth_balance.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip::margin_detail {

/// The work of a search; reproducible.
struct DegreeWork {
  std::size_t proofs = 0;  ///< parallelepipeds tried
  BranchWork cone;         ///< the work of the trees of their walls
};

class SegmentSearch {
 public:
  using Motion = Eigen::Vector3d;

  /// A family for all l >= 0, which has to outlive this.
  explicit SegmentSearch(const Problem& problem);

  /// Returns the work of all proofs.
  DegreeWork work() const { return {proofs_, crowd_.work()}; }

  /// Returns true if proofs are worth trying.
  bool is_possible() const { return model_.is_moderate && model_.stiffness > 0; }
  /// Returns about the size of the load and preloads of the member with h and l.
  double force_of(double h, double l) const;
  /// Returns an equilibrium of the member with h and l, in doubles. Friction is made less and
  /// less smooth, as far as that goes. The search begins at `near`, if that is given.
  std::optional<Motion> settle(double h, double l, const Motion* near);

  /// Seeks a proof that all multiples of a range are resisted, between equilibria at its ends.
  /// A short range gets more tries.
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
  std::size_t last_size_ = 0;  ///< the index of the size of K that served last
};

}  // namespace stickslip::margin_detail
