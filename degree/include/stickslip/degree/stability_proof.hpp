// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs that every grasp of a box is stable, without stating an equilibrium
/// (certificate/FORMAT.md, section 6): by degree, or at rest.
#pragma once

#include <utility>
#include <vector>

#include "stickslip/core/ids.hpp"
#include "stickslip/search/tree.hpp"

namespace stickslip {

/// Nothing moves: friction at rest f0 + sum of G_l z_l, with whatever |z_l| <= reach_l balances
/// a grasp of the box. A force of friction has as many coordinates as a slip.
struct RestProof {
  /// G of a contact: the friction with which it answers a unit of each component of a wrench.
  struct Answer {
    ContactId contact;                ///< whose friction it is
    std::vector<RationalRow> forces;  ///< by component, across its normal
  };
  std::vector<std::pair<ContactId, RationalRow>> friction;  ///< f0 by contact, increasing
  std::vector<Answer> answers;                              ///< by contact, increasing
  RationalRow reach;                                        ///< >= 0
};

/// Cuts of a box and proofs of its parts, in preorder.
using StabilityProof = PartsIn<DegreeProof, RestProof>;

/// Whether all parts are proved at rest.
bool are_at_rest(const StabilityProof& parts);

}  // namespace stickslip
