// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Cells of accelerations, in the plane and in space: the known state of a contact, and the
/// linear program of a cell.
#pragma once

#include <variant>
#include <vector>

#include "stickslip/core/row.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::earlier_detail {

/// The known state of the acceleration along a contact's normal.
enum class Touch {
  kUnknown,   ///< N.a >= 0
  kTouching,  ///< N.a = 0
  kApart      ///< N.a >= 0, no force
};

/// Evidence that no point has w.a > 0: multipliers of the rows and of w.a, coprime integers.
struct NoPower {
  Rational weight;                    ///< the multiplier of w.a; 0 if there is no point at all
  std::vector<Rational> multipliers;  ///< by row
};

/// Returns a point of the program with w.a > 0, of the greatest w.a if there is one. `load` is
/// w, and a are the first variables.
std::variant<std::vector<Rational>, NoPower> most_power(LinearProgram program,
                                                        const RationalRow& load);

}  // namespace stickslip::earlier_detail
