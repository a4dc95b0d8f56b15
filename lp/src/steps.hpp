// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The steps of solve: a proposal in double precision, its confirmation, and the exact simplex
/// method. Each has a file of its own, double_simplex.cpp, exact_basis.cpp and
/// integer_simplex.cpp.
#pragma once

#include <optional>
#include <vector>

#include "scaled_system.hpp"

namespace stickslip::lp_detail {

/// A basis, and the outcome that it is thought to prove.
struct Proposal {
  enum class Kind {
    kNone,        ///< gave up; the basis is only a place to start from
    kOptimal,     ///< the basis is feasible and optimal
    kInfeasible,  ///< `witness` is basic, of the wrong sign, and cannot change it
    kUnbounded,   ///< `witness` is nonbasic and can move in `direction` for ever
  };
  Kind kind = Kind::kNone;
  std::vector<Index> nonbasic;  ///< n variables, by the numbering of ScaledSystem
  Index witness = 0;
  /// The sign of the witness's value for kInfeasible; +1 to rise and -1 to fall for kUnbounded.
  int direction = 0;
};

/// Returns a proposal. It always ends, as the number of pivots is limited. Adds to
/// work.double_pivots.
Proposal propose(const ScaledSystem& system, LpWork& work);

/// Returns the evidence that a proposed basis gives if it verifies, else nothing. It starts in
/// `first_tier` arithmetic and updates `work`.
std::optional<LpResult> confirm(const LinearProgram& program, const ScaledSystem& system,
                                const Proposal& proposal, LpTier first_tier, LpWork& work);

/// Solves exactly from the basis with nonbasic set `start` (or from scratch when that is
/// empty), in `first_tier` arithmetic or larger. Updates `work`.
LpResult solve_exactly(const LinearProgram& program, const ScaledSystem& system,
                       std::vector<Index> start, LpTier first_tier, LpWork& work);

}  // namespace stickslip::lp_detail
