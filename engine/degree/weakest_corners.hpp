// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The corners of a box at which its load is lost soonest, in doubles: an adversary.
#pragma once

#include <vector>

#include "rounded_box.hpp"
#include "stickslip/engine/near_equilibrium.hpp"

namespace stickslip {

/// A corner of a box and the largest multiple of the load that is held there, as far as
/// Newton's method finds.
struct WeakCorner {
  RoundedBox::Place at;
  double multiple;
};

/// Returns corners at which a small multiple of the load is held, the smallest first. The first
/// descent begins in the middle, whose equilibrium it takes, others at random corners: each
/// step goes to the corner along the gradient of that multiple. There is no result where there
/// is no load, or of more than 256 numbers. A step takes a few searches for equilibria and
/// O(numbers contacts D).
std::vector<WeakCorner> weakest_corners(const RoundedBox& box, const NearEquilibrium& middle,
                                        std::size_t descents);

}  // namespace stickslip
