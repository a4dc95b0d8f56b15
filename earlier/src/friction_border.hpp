// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The factor of all friction above which forces in the cones balance a load.
#pragma once

#include <optional>

#include "stickslip/engine/problem.hpp"

namespace stickslip::earlier_detail {

/// Returns the same grasp with all friction times s >= 0.
Problem with_friction_times(const Problem& problem, const Rational& s);

/// The border between factors at which forces balance the load and smaller ones at which none
/// do: larger cones hold more. The border is a root of a quadratic equation; it is known
/// exactly if it is rational and the search finds it.
struct FrictionBorder {
  bool always_moves = false;  ///< no factor balances the load
  std::optional<Rational>
      moves;              ///< the load is not balanced below this factor; none: it always is
  bool moves_at = false;  ///< whether it is not balanced at this factor either
  std::optional<Rational> rests;  ///< the load is balanced above this factor; none: no such
                                  ///< factor was found
  bool rests_at = false;          ///< whether it is balanced at this factor as well
};

/// Returns the border for unilateral contacts at rest. If the border is rational and simple,
/// `moves` and `rests` are the same; else they are a millionth of the factor apart.
FrictionBorder friction_border(const Problem& problem);

}  // namespace stickslip::earlier_detail
