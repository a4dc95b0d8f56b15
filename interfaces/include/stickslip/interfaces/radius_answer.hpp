// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How far tolerances may grow, as `radius --json` prints it.
#pragma once

#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/measures/radius.hpp"

namespace stickslip {

/// Returns the verdict of the grasp in the middle of the box, and the two factors, before
/// finished().
Json radius_json(const Question& question, const Radius& radius);

}  // namespace stickslip
