// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Grasps of a box that are likely to differ from the middle, by margins of the load.
#pragma once

#include <vector>

#include "engine/box/examples.hpp"

namespace stickslip::extent_detail {

/// Returns places that are likely to have the verdict that the middle does not have, best
/// first. In the plane they follow from how the multiples of the load that are resisted change
/// with each number, which takes O(numbers) margins; else they are the extremes.
std::vector<box_detail::Place> suspects(const box_detail::Examples& examples,
                                        bool middle_is_stable);

}  // namespace stickslip::extent_detail
