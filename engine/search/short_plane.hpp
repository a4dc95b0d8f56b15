// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Planes of few bits in place of longer ones.
#pragma once

#include <vector>

#include "stickslip/engine/motion_region.hpp"

namespace stickslip::search_detail {

/// Returns whether cuts by the planes would make rays of so many bits that exact arithmetic is
/// slow.
bool are_long(const std::vector<Row>& planes);

/// Returns a plane of few bits, a little nearer to the motion than all of these planes, which
/// have the motion on this side; on that side of it all of them have one sign. Returns 0 if it
/// would not cut the region, for a margin, and if the region is not narrow: only in a narrow
/// one can what rounding takes away at its points be given back.
Row short_plane(const Law& law, const MotionRegion& region, const std::vector<Row>& planes,
                const Reals& motion, int side);

}  // namespace stickslip::search_detail
