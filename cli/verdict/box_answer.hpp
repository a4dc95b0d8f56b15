// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How `decide` prints the answer to a question that is a box, or about a grasp in space.
#pragma once

#include <string>

#include "question_options.hpp"
#include "stickslip/answers/verdict_answer.hpp"

namespace stickslip {

/// `examples`: the folder to which those of a fragile box are written; may be empty.
void print_text(const BoxAnswer& answer, const NumberOptions& output,
                const std::string& examples);

/// The two grasps of a fragile box, each with the certificate of its verdict. Says so on
/// standard error if there are none.
void write_examples(const BoxAnswer& answer, const std::string& folder);

/// If the verdict has one. Says so on standard error of a fragile box, which has two others.
void write_certificate(const BoxAnswer& answer, const std::string& file);

}  // namespace stickslip
