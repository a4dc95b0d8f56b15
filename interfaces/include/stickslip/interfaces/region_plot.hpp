// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The picture of resistible wrenches (Haas-Heger et al., RSS 2018, Fig. 7).
#pragma once

#include <string>
#include <vector>

#include "stickslip/engine/question.hpp"
#include "stickslip/measures/resistible_set.hpp"

namespace stickslip {

/// Returns SVG of the region, in the coordinates (s, t) of the plane. The window is a square
/// around the origin and all vertices. A region that reaches its frame goes on without end; its
/// unbounded borders have arrow heads there. Few vertices are labelled; data-vertices of the
/// class "area" has all that lie in the window, its corners included, exactly.
std::string plot_region(const Question& question, const WrenchPlane& plane,
                        const PlaneUnion& region);

}  // namespace stickslip
