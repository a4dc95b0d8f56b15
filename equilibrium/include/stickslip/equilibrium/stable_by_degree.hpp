// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Stable by degree (certificate/FORMAT.md, section 6), of one grasp in exact numbers: in place
/// of an equilibrium whose numbers may have tens of thousands of digits
/// (has_long_equilibria).
#pragma once

#include <optional>

#include "stickslip/equilibrium/search/branch_and_bound.hpp"
#include "stickslip/equilibrium/search/degree.hpp"

namespace stickslip {

/// A parallelepiped of motions that holds an equilibrium of one grasp; its trees are list 2.
using ProofByDegree = DegreeProofIn<RefutationNode>;

/// What it took; reproducible.
struct DegreeWork {
  std::size_t proofs = 0;  ///< parallelepipeds tried
  ConeWork cone;           ///< of the trees of their walls
};

/// Nothing if no proof was found, which says nothing about the verdict; that is soon where
/// Newton's method, from rest, leads to no equilibrium. Deterministic. O(m) for each of at most
/// some ten thousand nodes, mostly a hundred. Throws ContractError if the problem is a family.
std::optional<ProofByDegree> prove_by_degree(const Problem& problem,
                                             DegreeWork* work = nullptr);

}  // namespace stickslip
