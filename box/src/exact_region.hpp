// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What is true of a region where doubles do not decide: of one grasp whose slips have one
/// dimension, by exact linear programs.
#pragma once

#include <variant>

#include "stickslip/equilibrium/verdict.hpp"
#include "stickslip/search/grasp_law.hpp"
#include "stickslip/search/motion_region.hpp"

namespace stickslip::box_detail {

/// Whether decide_exactly() can be asked of regions of this law, which is of one grasp without
/// irrational lengths: friction is along a line.
bool is_linear(const Law& law);

/// A leaf that refutes the region, the contact to split, or an equilibrium in it. As contacts
/// can be split only so often, a search that asks this ends. A program with D rows and one for
/// each contact for each strict function.
std::variant<TreeNode, ShareWitness> decide_exactly(const Law& law, const MotionRegion& region);

}  // namespace stickslip::box_detail
