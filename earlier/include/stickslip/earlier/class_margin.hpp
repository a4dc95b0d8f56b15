// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The margin of a class (load_classes.hpp): which multiples of a load must move, must hold, or
/// are open.
///
/// **Weakly stable** under w + l u are the l of an interval: forces in the cones and l are
/// linear, and one exact program finds each end.
///
/// **Not strongly stable** are those l for which a solution with a != 0 exists. In a closed
/// cell of the model, with a in one orthant, solutions are convex in (a, forces, l), and so are
/// those with a != 0, where the sum of |a_j| is positive. So each cell gives an interval of l,
/// whose ends two programs find, and a third for each end whether it belongs to it. What must
/// hold is what none of finitely many cells takes away: intervals with rational ends, with or
/// without them, and there may be gaps.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "stickslip/earlier/load_classes.hpp"

namespace stickslip {

/// Which of the classes.
enum class RigidClass { kMustMove, kMustHold, kOpen };
/// "must move", "must hold" or "open"
std::string to_string(RigidClass rigid_class);

/// All multiples from low to high, or from low on, are of one class.
struct ClassRange {
  RigidClass rigid_class;        ///< of all of them
  Rational low;                  ///< the least, or where it begins
  std::optional<Rational> high;  ///< none: without end
  bool has_low;                  ///< whether low is one of them; else it ends the range before
  bool has_high;                 ///< the same of high
};

/// The classes of all multiples l >= 0 of the family (Problem::along; its preloads play no
/// part), in their order. Undecided only at `most_programs` linear programs.
std::variant<std::vector<ClassRange>, Undecided> class_margin(
    const Problem& family, const Inertia& inertia = {}, std::size_t most_programs = 20000);

}  // namespace stickslip
