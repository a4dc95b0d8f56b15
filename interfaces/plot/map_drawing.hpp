// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Cells that are proved one by one, in pictures of maps and of sections.
#pragma once

#include "stickslip/interfaces/svg.hpp"
#include "stickslip/measures/map.hpp"

namespace stickslip::plot_detail {

/// A rectangle from its upper left corner on, that looks as its verdict does and has its exact
/// ends in data-x and data-y.
void draw_cell(Svg& svg, const MapCell& cell, InkPoint from, InkPoint to);

}  // namespace stickslip::plot_detail
