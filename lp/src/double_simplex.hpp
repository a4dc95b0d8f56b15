// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The simplex method in double precision: fast, fallible, and asked only for a proposal.
#pragma once

#include <vector>

#include "scaled_system.hpp"

namespace stickslip::lp_detail {

/// A basis, and what it is thought to prove.
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
  /// kInfeasible: sign of the witness's value; kUnbounded: +1 to rise, -1 to fall.
  int direction = 0;
};

/// Always ends (the number of pivots is limited). Adds to work.double_pivots.
Proposal propose(const ScaledSystem& system, LpWork& work);

}  // namespace stickslip::lp_detail
