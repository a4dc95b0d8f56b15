// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The text for people of a verdict of `decide`, with its evidence.
#pragma once

#include <string>

#include "question_options.hpp"
#include "stickslip/interfaces/samples_answer.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {

/// Prints the verdict. `examples` is the folder to which the examples of a fragile box are
/// written; it may be empty. `samples` are those that were asked for, or null.
void print_text(const Answer& answer, const Warnings& warnings, const NumberOptions& output,
                const std::string& examples, const Samples* samples = nullptr);

}  // namespace stickslip
