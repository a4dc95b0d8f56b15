// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Planes of few bits in place of longer ones.
#pragma once

#include <vector>

#include "stickslip/engine/motion_region.hpp"

namespace stickslip::search_detail {

/// Whether cuts by the planes would make rays of so many bits that all that is exact is slow.
bool are_long(const std::vector<Row>& planes);

/// In few bits, a little nearer to the motion than all of these planes, on this side of which
/// it is, so that they have one sign beyond it; 0 if that is no plane of the region. Only where
/// the region is narrow: what rounding takes away at its points can then be given back. Not of
/// a margin.
Row short_plane(const Law& law, const MotionRegion& region, const std::vector<Row>& planes,
                const Reals& motion, int side);

}  // namespace stickslip::search_detail
