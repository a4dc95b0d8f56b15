// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The friction margin of a class (load_classes.hpp): by which factor all friction may change
/// before the class does.
///
/// **Must move** are all factors below a border, as larger cones hold more. A twist that no
/// force opposes at one factor is opposed by none up to another factor; forces that balance the
/// load do so down to another. The search goes on from both. The border is where two edges of
/// cones and the load are in one plane: a root of a quadratic equation. A rational and simple
/// root is found and proved (friction_border.hpp); any other root is only known to lie between
/// two factors.
///
/// **Must hold** is not monotone. Cells of solutions (rigid_cells.hpp) are relaxed to all
/// factors of a range: if none of them has an acceleration, the whole range must hold. Ranges
/// are joined from one factor on, to both sides, until a factor is met that leaves the load
/// open.
///
/// The class between is not known: the model is not linear in the factor and an acceleration.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/earlier/class_margin.hpp"

namespace stickslip {

/// A range of factors of one class, from low to high, or from low on.
struct FactorRange {
  std::optional<RigidClass> rigid_class;  ///< the class of all of them; none: not known
  Rational low;                           ///< the least one, or the limit from which they start
  std::optional<Rational> high;           ///< none: without end
  bool has_low;                           ///< whether low is one of them
  bool has_high;                          ///< whether high is one of them
};

/// Returns the classes of all factors s >= 0 of all friction, in their order. The range that
/// must hold is the one about s = 1, or about the least factor that balances the load if that
/// is above 1. If it ends at a load that is open, its end is known to `accuracy` of the factor.
/// Each of at most some hundred searches takes up to `most_programs` programs; factors that
/// they do not settle are not known.
std::vector<FactorRange> friction_margin(const Problem& problem, const Inertia& inertia = {},
                                         const Rational& accuracy = Rational(1, 1000),
                                         std::size_t most_programs = 2000);

}  // namespace stickslip
