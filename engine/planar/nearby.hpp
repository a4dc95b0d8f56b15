// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// From what somebody else computed, rounding errors included, to an exact equilibrium of the
/// same kind: the same contacts closed, the same ones slipping, the same way.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// An approximate equilibrium. Any numbers will do; what is left out is not known.
struct ApproximateEquilibrium {
  std::optional<Twist> twist;                       ///< the motion d
  std::optional<std::vector<ContactForce>> forces;  ///< one per contact
};

/// An equilibrium with the modes that the approximation suggests. Which contacts are closed,
/// slip or stick is read off the forces, or without them off the twist, taking what is small
/// for zero at a few levels of "small"; each reading is a linear system, solved exactly for the
/// motion and at most three friction forces, and as near to the approximation as it leaves
/// open. Then Newton's method from the twist, in doubles, proposes modes. What is returned has
/// passed find_violation; nothing if no proposal does, which says nothing about the verdict.
/// O(m) rational operations for each of a few proposals. Throws ContractError unless there is a
/// twist or a list of one force per contact.
std::optional<Witness> find_witness_like(const Problem& problem,
                                         const ApproximateEquilibrium& approximate);

}  // namespace stickslip
