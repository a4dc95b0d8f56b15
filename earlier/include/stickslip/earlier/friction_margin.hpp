// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The friction margin of a class (load_classes.hpp): by which factor all friction may change
/// before the class does.
///
/// **Must move** are all factors below a border, as larger cones hold more. A twist that no
/// force opposes at one factor is opposed by none up to another, forces that balance the load
/// do so down to another, and both go on from there. The border is where two edges of cones and
/// the load are in one plane: a root of a quadratic equation. Where it is rational and simple
/// it is found and proved (friction_border.hpp); else two factors are known that it lies
/// between.
///
/// **Must hold** is not monotone. Cells of solutions (rigid_cells.hpp) are relaxed to all
/// factors of a range: where none of them has an acceleration, the whole range must hold.
/// Ranges are joined from one factor on, to both sides, until a factor is met that leaves the
/// load open.
///
/// What is between is not known: the model is not linear in the factor and an acceleration.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/earlier/class_margin.hpp"

namespace stickslip {

/// All factors from low to high, or from low on, are of one class.
struct FactorRange {
  std::optional<RigidClass> rigid_class;  ///< of all of them; none: not known
  Rational low;                           ///< the least, or where it begins
  std::optional<Rational> high;           ///< none: without end
  bool has_low;                           ///< whether low is one of them
  bool has_high;                          ///< the same of high
};

/// The classes of all factors s >= 0 of all friction, in their order. Where what must hold
/// about s = 1 (or about the least factor that balances the load, if that is above) ends at a
/// load that is open, the end is known to `accuracy` of the factor. `most_programs` of each of
/// at most some hundred searches; what they do not settle is not known.
std::vector<FactorRange> friction_margin(const Problem& problem, const Inertia& inertia = {},
                                         const Rational& accuracy = Rational(1, 1000),
                                         std::size_t most_programs = 2000);

}  // namespace stickslip
