// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The sphere of motions for drawing.
#pragma once

#include "stickslip/core/grasp.hpp"
#include "stickslip/core/number_text.hpp"

namespace stickslip::page_detail {

/// The member `states` of a page's answer (answer.hpp).
Json cells_json(const Grasp& grasp);

}  // namespace stickslip::page_detail
