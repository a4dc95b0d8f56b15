// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One stylesheet for all pictures: colours that colour-blind readers can tell apart (Okabe and
/// Ito for lines, Tol's "light" for areas), light on screens that ask for dark, never in print.
/// Every meaning has a second cue: line style, arrow head, hatching or a label.
#pragma once

#include <string_view>

#include "stickslip/interfaces/svg.hpp"

namespace stickslip::plot_detail {

/// Colours for areas that must be told apart: classes "hue0", ..., and hatched "hatch0", ....
inline constexpr int kHues = 8;
/// Colours for areas in an order: classes "shade0" (light), ....
inline constexpr int kShades = 9;

/// Lengths in pixels, of all pictures: around them, from a line of text to the next, and above
/// a chart.
inline constexpr double kMargin = 24;
inline constexpr double kLine = 19;
inline constexpr double kTop = 64;

/// Returns the rules. Colours are in the rules, not in custom properties: converters know no
/// var().
std::string_view stylesheet();

/// Defines the fills "hatch0", ...: they are patterns, which must be defined before they are
/// used.
void define_hatching(Svg& svg);

}  // namespace stickslip::plot_detail
