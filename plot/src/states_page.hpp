// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The page of a states plot: where the discs are, and what stands around the cells.
#pragma once

#include <array>
#include <string>

#include "picture_frame.hpp"
#include "stickslip/arrangement/slip_states.hpp"

namespace stickslip::plot_detail {

inline constexpr double kDiscMiddle = 238;  ///< y of the discs and of the grasp
inline constexpr double kDiscRadius = 148;

/// Counterclockwise and clockwise motions: r > 0 and r < 0.
inline constexpr std::array<View, 2> kDiscs{View{{412, kDiscMiddle}, kDiscRadius},
                                            View{{750, kDiscMiddle}, kDiscRadius}};

/// The contacts and the lines along their tangents: the centres of rotation about which they
/// stick. `grasp` is in scene coordinates. Returns how many contacts found no room for numbers.
std::size_t draw_grasp_panel(Svg& svg, const Grasp& grasp);

/// Motions that turn about points at distance 1 in the scene.
void draw_rings(Svg& svg);

/// The rims, what is drawn in which disc, and which translations are where.
void draw_rims(Svg& svg);

/// "3 contacts on 3 circles, rank 3: ..."
std::string counts_text(const ArrangementCounts& counts);

}  // namespace stickslip::plot_detail
