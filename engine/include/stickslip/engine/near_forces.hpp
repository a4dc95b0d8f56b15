// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Forces for people, where a proof says that there is an equilibrium but not which one.
#pragma once

#include <vector>

#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {

/// Returns forces near those of an equilibrium near the motion (or the state) d, by contact,
/// from doubles. A contact that nearly sticks has slip 0, and a friction within its cone such
/// that all forces together come nearest to balance. Requires a question that is a box.
std::vector<SpatialForce> near_forces(const Question& question, const RationalRow& d);

}  // namespace stickslip
