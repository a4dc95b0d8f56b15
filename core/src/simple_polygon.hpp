// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Checks that rings are a polygon with holes.
#pragma once

#include <string>

#include "stickslip/core/grasp.hpp"

namespace stickslip::core_detail {

/// Throws InputError at `path` unless the rings are simple: no two edges meet, except
/// neighbours where one ends and the other begins, and every hole lies inside the outer ring
/// and outside of all other holes. Requires rings of three vertices or more, each unlike the
/// next. Takes time proportional to the pairs of edges whose ranges of x overlap.
void check_simple(const Polygon& polygon, const std::string& path);

}  // namespace stickslip::core_detail
