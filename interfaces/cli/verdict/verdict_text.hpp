// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How `decide` shows people a verdict with its evidence.
#pragma once

#include <string>

#include "question_options.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {

/// Prints it. `examples`: the folder to which those of a fragile box are written; may be empty.
void print_text(const Answer& answer, const NumberOptions& output, const std::string& examples);

}  // namespace stickslip
