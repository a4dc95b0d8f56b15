// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Forces for people, where a proof says that there is an equilibrium and not which.
#pragma once

#include <vector>

#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {

/// Forces near those of an equilibrium near the motion d, or the state, by contact, in doubles.
/// What nearly sticks has slip 0, and friction within its cone by which the sum comes nearest
/// to 0. Requires a question that is a box.
std::vector<SpatialForce> near_forces(const Question& question, const RationalRow& d);

}  // namespace stickslip
