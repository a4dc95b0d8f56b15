// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Finds an exact equilibrium of the same kind as one that somebody else computed, rounding
/// errors included: the same contacts closed, the same ones slipping, the same way.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// An approximate equilibrium. Any numbers will do; members left out are not known.
struct ApproximateEquilibrium {
  std::optional<Twist> twist;                       ///< the motion d
  std::optional<std::vector<ContactForce>> forces;  ///< one per contact
};

/// Returns an equilibrium with the modes that the approximation suggests, or the approximation
/// itself if it is an equilibrium. The forces, or without them the twist, tell which contacts
/// are closed, slip or stick; small numbers count as zero at a few levels of "small". Each such
/// reading is a linear system. It is solved exactly for the motion and at most three friction
/// forces; where it has several solutions, one near the approximation is taken. If no reading
/// works, Newton's method from the twist, in doubles, proposes modes. The result has passed
/// find_violation. Returns nothing if no proposal does, which says nothing about the verdict.
/// O(m) rational operations for each of a few proposals. Throws ContractError unless there is a
/// twist or a list of one force per contact.
std::optional<Witness> find_witness_like(const Problem& problem,
                                         const ApproximateEquilibrium& approximate);

}  // namespace stickslip
