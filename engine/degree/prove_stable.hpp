// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs that every grasp of a box is stable, around an equilibrium of its middle
/// (certificate/FORMAT.md, section 6).
#pragma once

#include <optional>

#include "newton.hpp"
#include "stickslip/engine/proof.hpp"
#include "stickslip/engine/search_work.hpp"

namespace stickslip {

/// The limits of a proof.
struct DegreeLimits {
  std::size_t node_limit;  ///< the limit of a wall's tree; 0: only what is quick is tried
  std::size_t most_nodes;  ///< once all trees have so many in all, nothing is tried in space
  bool is_wide;            ///< the user gave intervals; the box is not just rounding of lengths
};

/// Tries to prove that every grasp in the box has an equilibrium near this one of its middle,
/// which is `middle`; for a margin, at all of its multiples. Adds to `work`.
std::optional<DegreeProof> prove_by_degree(const GraspLaw& box, const GraspLaw& middle,
                                           const NearEquilibrium& near,
                                           const DegreeLimits& limits, SearchWork& work);

/// Tries the same where prove_by_degree() fails as a body floats, touched by nothing: about the
/// grasps without the contacts that it might come to, which are open on all of the body.
std::optional<DegreeProof> prove_beside(const GraspLaw& box, const GraspLaw& middle,
                                        const NearEquilibrium& near, const DegreeLimits& limits,
                                        SearchWork& work);

/// Tries the same for one grasp in the plane, around an equilibrium of its own, however many
/// contacts it has; not for a family.
std::optional<DegreeProof> prove_by_degree(const Problem& problem, SearchWork& work);

/// Tries a proof near an equilibrium of the middle that is at rest: nothing moves, and friction
/// answers whatever load is left. The proof is verified exactly by the rules of the format.
/// O(contacts).
std::optional<RestProof> prove_at_rest(const GraspLaw& box, const NearEquilibrium& middle);

/// Tries a proof near an equilibrium of the middle at which all contacts that press and rub
/// stick, though it may move: contacts press a little more or less, and friction answers the
/// rest. The proof is verified exactly by the rules of the format. O(contacts).
std::optional<StickingProof> prove_sticking(const GraspLaw& box, const NearEquilibrium& middle);

}  // namespace stickslip
