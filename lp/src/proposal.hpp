// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the double simplex suggests: a basis, and what it is thought to prove.
#pragma once

#include <vector>

#include "scaled_system.hpp"

namespace stickslip::lp_detail {

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

}  // namespace stickslip::lp_detail
