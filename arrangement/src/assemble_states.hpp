// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// From the cells of an arrangement of distinct circles to the slip states of the planes:
/// the last step that every enumerator shares.
#pragma once

#include "sign_rows.hpp"
#include "stickslip/arrangement/slip_states.hpp"

namespace stickslip {

/// Makes the sorted slip states from `cell_signs`, the signs of circles.normals[c].d on each
/// cell of the sphere, and completes `counts`, of which vertices, edges and faces are given.
/// Adds the all-stick state. Throws ContractError when the counts contradict one another:
/// Euler, antipodal pairs, and the relation of cells to states that slip_states.hpp states.
SlipStates assemble_states(const GreatCircles& circles, SignRows cell_signs,
                           ArrangementCounts counts);

}  // namespace stickslip
