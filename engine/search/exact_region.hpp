// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Decides regions where doubles do not, by exact linear programs: regions of one grasp whose
/// slips have one dimension.
#pragma once

#include <variant>

#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/engine/motion_region.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// Returns a leaf that refutes the region for the law's load, or for all loads of its hull, the
/// contact to split, or an equilibrium in it (under no hull). As contacts can be split only so
/// often, a search that asks this ends. It solves a program for each strict function
/// (relaxed_region.hpp). The law is that of one grasp without irrational lengths;
/// law.is_linear() is required.
std::variant<TreeNode, ShareWitness> decide_exactly(const Law& law, const MotionRegion& region);

}  // namespace stickslip
