// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The exact simplex method: dictionaries of integers over one common denominator.
///
/// A dictionary says D b_i = M_i0 + sum_j M_ij v_j for every basic b_i over the nonbasic v_j;
/// D > 0 and all M_ij are minors of the scaled rows, so each pivot divides exactly (Edmonds
/// 1967, Bareiss 1968).
///
/// 1. Basic slacks of equations leave; they never return.
/// 2. Feasibility: the basic variable >= 0 of least number among those with a negative value
///    leaves; a free nonbasic variable of nonzero coefficient enters if there is one (it never
///    leaves again), else the variable >= 0 of least number with a positive coefficient. If
///    there is none, the row proves infeasibility.
/// 3. Optimality: Bland's rule for the primal simplex method.
///
/// *Termination.* Steps that move an equation's slack out or a free variable in are at most
/// m + n. Between them, 3 is Bland 1977, and 2 is Bland's rule for the dual simplex method
/// with zero cost. Directly: suppose 2 repeats a basis, and t is the largest of the variables
/// that move in the cycle. In some dictionary P, t leaves: t < 0, and the others that move are
/// >= 0 or nonbasic. In another, Q, t enters in the row of some r: its constant is negative,
/// t's coefficient positive, those of the others that move <= 0. Put P's basic solution in
/// that row, r - sum a_j v_j = constant < 0: variables that do not move are nonbasic in P
/// (being nonbasic in Q) and so 0; every remaining term on the left is >= 0. Contradiction.
#pragma once

#include <vector>

#include "scaled_system.hpp"

namespace stickslip::lp_detail {

/// Solves from the basis with nonbasic set `start` (or from scratch when that is empty), in
/// `first_tier` arithmetic or larger. Updates `work`.
LpResult solve_exactly(const LinearProgram& program, const ScaledSystem& system,
                       std::vector<Index> start, LpTier first_tier, LpWork& work);

}  // namespace stickslip::lp_detail
