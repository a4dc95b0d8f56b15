// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact equilibria of one grasp of many coordinates, from modes in doubles.
#pragma once

#include <cstdint>
#include <variant>

#include "sparse_newton.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip::large_detail {

/// Why there is no exact equilibrium.
enum class NoEquilibrium : std::int8_t {
  kIrrational,  ///< a contact slips in space, where friction has irrational numbers
  kOpens,       ///< contacts open, though they may not
  kModes,       ///< no modes near the proposal have one
};

/// Returns an equilibrium with these modes, or with others near them: those that break a law
/// are changed, all at once, for some rounds. With given modes motions and the friction of
/// contacts that stick solve linear equations. Where these leave friction open, it is what the
/// proposal has, in few bits, at the contacts that have least to spare.
std::variant<ShareWitness, NoEquilibrium> equilibrium_near(const LargeGrasp& grasp,
                                                           const LargeProposal& proposal);

}  // namespace stickslip::large_detail
