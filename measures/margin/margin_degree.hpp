// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Segments of a margin proved by degree (certificate/FORMAT.md, section 5): a parallelepiped
/// of motions that moves with the multiple holds an equilibrium of each. The numbers of such a
/// proof have about as many digits as those of the contacts, however long the equilibria would
/// be.
///
/// **Method.** Equilibria are followed in doubles (smooth_balance.hpp). K goes in a straight
/// line from one of them to another and is |J e| <= rho by coordinates. J is how forces answer
/// motions half-way, with friction made smooth over the slips that K has. So on a wall a force
/// of about rho is left over, whatever the friction that K leaves open does. The trees of the
/// walls are sought for one rho after another; if none serves, the search goes on with half of
/// the multiples.
#pragma once

#include <vector>

#include "segment_search.hpp"

namespace stickslip::margin_detail {

class DegreeChain {
 public:
  /// A family for all l >= 0, which has to outlive this.
  explicit DegreeChain(const Problem& family) : search_(family) {}

  /// Returns segments by degree, increasing and disjoint but for their ends: from 0 upwards as
  /// far as they go, and from a few multiples beyond.
  std::vector<MarginSegment> find();

  /// Returns the work done so far.
  DegreeWork work() const { return search_.work(); }

 private:
  using Motion = SegmentSearch::Motion;

  void extend(const Rational& low, double typical, std::vector<MarginSegment>& found);

  SegmentSearch search_;
};

}  // namespace stickslip::margin_detail
