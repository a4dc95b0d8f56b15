// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How `decide` answers a question that is a box.
#pragma once

#include <cstddef>
#include <string>

#include "question_options.hpp"
#include "stickslip/box/box_verdict.hpp"

namespace stickslip {

struct BoxAnswer {
  Question question;
  BoxDecision decision;
};

BoxAnswer answer_box(Question question, std::size_t node_limit);

Json to_json(const BoxAnswer& answer);
/// `examples`: the folder to which those of a fragile box are written; may be empty.
void print_text(const BoxAnswer& answer, const NumberOptions& output,
                const std::string& examples);

/// The two grasps of a fragile box, each with the certificate of its verdict. Says so on
/// standard error if there are none.
void write_examples(const BoxAnswer& answer, const std::string& folder);

/// If the verdict has one. Says so on standard error of a fragile box, which has two others.
void write_certificate(const BoxAnswer& answer, const std::string& file);

}  // namespace stickslip
