// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The law of a box of parameters.
#pragma once

#include "stickslip/box/parameter_box.hpp"
#include "stickslip/search/law.hpp"

namespace stickslip::box_detail {

/// Motions have three coordinates, slips one. What is multilinear is so in x, y and turn.
Law law_of(const ParameterBox& box);

}  // namespace stickslip::box_detail
