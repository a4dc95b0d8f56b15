// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The naive twin of resistible_set().
#pragma once

#include <vector>

#include "stickslip/measures/resistible_set.hpp"

namespace stickslip::test {

/// What each mode resists, whether it is near the plane or not, in the order of the slip
/// states, then of the separations: all O(m^3) modes, the cells that the planes tau_i = 0 and
/// v_i = 0 cut from the space of motions.
std::vector<ResistiblePiece> pieces_of_all_modes(const Problem& problem,
                                                 const WrenchPlane& plane);

}  // namespace stickslip::test
