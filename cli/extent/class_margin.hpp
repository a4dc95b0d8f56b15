// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What `margin --class` answers.
#pragma once

#include <string>

#include "question_options.hpp"

namespace stickslip {

/// Prints which multiples of the direction are of which class, for that --inertia. Returns the
/// exit code.
int answer_class_margin(const Question& question, const std::string& inertia,
                        const NumberOptions& output);

}  // namespace stickslip
