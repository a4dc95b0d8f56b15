// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// From a proposed basis to exact evidence.
///
/// The nonbasic slacks give k rows I and the basic x_j give k columns J. With the other x_j at
/// 0, the point solves G_IJ x_J = -h_I, the multipliers y G_IJ = (objective or witness row)_J,
/// the ray G_IJ d_J = (entering column)_I: at most two k x k systems, solved by fraction-free
/// Gauss-Jordan elimination (Bareiss 1968) in O(k^3).
#pragma once

#include <optional>

#include "double_simplex.hpp"
#include "scaled_system.hpp"

namespace stickslip::lp_detail {

/// The evidence if it verifies, else nothing. Starts in `first_tier` arithmetic; updates
/// `work`.
std::optional<LpResult> confirm(const LinearProgram& program, const ScaledSystem& system,
                                const Proposal& proposal, LpTier first_tier, LpWork& work);

}  // namespace stickslip::lp_detail
