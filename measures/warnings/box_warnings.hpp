// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "stickslip/engine/decide.hpp"
#include "stickslip/measures/model_traps.hpp"

namespace stickslip::warnings_detail {

/// Returns the warnings of model_warnings() about an answer that is about a box.
std::vector<ModelWarning> box_warnings(const Answer& answer, bool only_of_motion);

}  // namespace stickslip::warnings_detail
