// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The margin of a class (load_classes.hpp): which multiples of a load must move, must hold, or
/// are open.
///
/// **Weakly stable** under w + l u are the l of an interval: forces in the cones and l obey
/// linear conditions, and one exact program finds each end.
///
/// **Not strongly stable** are those l for which a solution with a != 0 exists. In a closed
/// cell of the model, with a in one orthant, solutions are convex in (a, forces, l). So are
/// those with a != 0, as the sum of |a_j| is positive there. So each cell gives an interval of
/// l. Two programs find its ends, and a third for each end says whether the end belongs to it.
/// The l that none of finitely many cells takes away must hold: intervals with rational ends,
/// with or without them, and there may be gaps.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "stickslip/earlier/load_classes.hpp"

namespace stickslip {

/// The classes of a load.
enum class RigidClass { kMustMove, kMustHold, kOpen };
/// Returns "must move", "must hold" or "open".
std::string to_string(RigidClass rigid_class);

/// A range of multiples of one class, from low to high, or from low on.
struct ClassRange {
  RigidClass rigid_class;        ///< the class of all of them
  Rational low;                  ///< the least one, or the limit from which they start
  std::optional<Rational> high;  ///< none: without end
  bool has_low;   ///< whether low is one of them; else it belongs to the range before
  bool has_high;  ///< whether high is one of them
};

/// Returns the classes of all multiples l >= 0 of the family (Problem::along; its preloads play
/// no part), in their order. Undecided only at `most_programs` linear programs.
std::variant<std::vector<ClassRange>, Undecided> class_margin(
    const Problem& family, const Inertia& inertia = {}, std::size_t most_programs = 20000);

}  // namespace stickslip
