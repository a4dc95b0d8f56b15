// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Drawn cells of maps and of sections, each of which is proved by itself.
#pragma once

#include "stickslip/interfaces/svg.hpp"
#include "stickslip/measures/map.hpp"

namespace stickslip::plot_detail {

/// Draws a rectangle from its upper left corner on. It looks as its verdict does and has its
/// exact ends in data-x and data-y.
void draw_cell(Svg& svg, const MapCell& cell, InkPoint from, InkPoint to);

}  // namespace stickslip::plot_detail
