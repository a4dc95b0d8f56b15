// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Equilibria of a body in space, or of several, by exact linear programs in contact modes.
#pragma once

#include <optional>

#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip::degree_detail {

/// Returns an equilibrium whose contact modes are near these, or nothing if none was found.
///
/// Our idea is that with modes given (open, sticking, slipping to one side) motions and forces
/// of equilibria are a polyhedron, of any dimension: where equilibria lie side by side, as in
/// what is drawn with symmetry, Newton's method has no one to converge to, and a linear program
/// does not mind. Modes that doubles do not tell apart are left open at first, and tried one
/// after another where the program's point breaks their law. A program has D + O(m) rows; a
/// limited number is solved. In space contacts with friction
/// stick or are open, and forces of those that stick are in polygons in their cones.
/// Requires that no number is uncertain.
std::optional<ShareWitness> equilibrium_in_modes(const GraspLaw& law,
                                                 const NearEquilibrium& near);

}  // namespace stickslip::degree_detail
