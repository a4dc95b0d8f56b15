// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How `decide` prints the answer to a question about a grasp in space.
#pragma once

#include <string>

#include "question_options.hpp"
#include "stickslip/answers/verdict_answer.hpp"

namespace stickslip {

void print_text(const SpaceAnswer& answer, const NumberOptions& output,
                const std::string& examples);

/// "(1, [2, 3], ...)" of the load w.
std::string load_text(const SpaceAnswer& answer, NumberText& text);

/// The two grasps of a fragile box, each with the certificate of its verdict. Says so on
/// standard error if there are none.
void write_examples(const SpaceAnswer& answer, const std::string& folder);

/// If the verdict has one. Says so on standard error of a fragile box, which has two others.
void write_certificate(const SpaceAnswer& answer, const std::string& file);

}  // namespace stickslip
