// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// From which factor of all friction on forces in the cones balance a load.
#pragma once

#include <optional>

#include "stickslip/engine/problem.hpp"

namespace stickslip::earlier_detail {

/// The same grasp with all friction times s >= 0.
Problem with_friction_times(const Problem& problem, const Rational& s);

/// Larger cones hold more: forces balance the load for all factors above a border, for none
/// below it. The border is a root of a quadratic equation, and known where it is rational and
/// found.
struct FrictionBorder {
  bool always_moves = false;  ///< no factor balances the load
  std::optional<Rational>
      moves;              ///< the load is not balanced below this factor; none: always is
  bool moves_at = false;  ///< nor at it
  std::optional<Rational> rests;  ///< balanced above this factor; none: none was found that is
  bool rests_at = false;          ///< and at it
};

/// Of unilateral contacts at rest. If it is rational and simple, `moves` and `rests` are the
/// same; else they are a millionth of the factor apart.
FrictionBorder friction_border(const Problem& problem);

}  // namespace stickslip::earlier_detail
