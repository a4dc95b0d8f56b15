// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The picture of a verdict as a part of another one.
#pragma once

#include "stickslip/engine/question.hpp"
#include "stickslip/engine/verdict.hpp"
#include "stickslip/interfaces/svg.hpp"

namespace stickslip::plot_detail {

/// The width of the picture, with margins.
inline constexpr double kGraspWidth = 800;

/// Draws all of plot_grasp() but its title, which has room above. Returns the baseline of the
/// line below.
double draw_grasp(Svg& svg, const Question& question, const Verdict& verdict);

}  // namespace stickslip::plot_detail
