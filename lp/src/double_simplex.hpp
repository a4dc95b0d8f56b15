// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The simplex method in double precision: fast, fallible, and asked only for a proposal.
#pragma once

#include "proposal.hpp"
#include "scaled_system.hpp"

namespace stickslip::lp_detail {

/// Always ends (the number of pivots is limited). Adds to work.double_pivots.
Proposal propose(const ScaledSystem& system, LpWork& work);

}  // namespace stickslip::lp_detail
