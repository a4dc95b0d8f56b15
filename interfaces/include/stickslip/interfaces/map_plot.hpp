// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The picture of a map of verdicts (measures/map.hpp).
#pragma once

#include <string>
#include <vector>

#include "stickslip/measures/map.hpp"

namespace stickslip {

/// Returns SVG of cells that tile the rectangle of the axes: stable, unstable (hatched), and
/// white if nothing is proved. Each cell has its exact ends in data-x and data-y.
std::string plot_map(const std::string& name, const MapAxis& x_axis, const MapAxis& y_axis,
                     const std::vector<MapCell>& cells);

}  // namespace stickslip
