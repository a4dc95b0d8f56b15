// SPDX-License-Identifier: MIT
/// \file
/// The checker as a function: does this certificate prove its verdict about this question, or
/// its margin where the question has a direction?
/// Only FORMAT.md, beside this folder, is trusted to define what that means; nothing of the
/// certificate is, and no solver takes part.
#pragma once

#include <istream>
#include <string>

#include "answer.hpp"
#include "question.hpp"

namespace stickslip_check {

/// Reads both files and answers (FORMAT.md §6). The names are for messages. Throws nothing but
/// what the machine does (no memory). `exact_only` decides leaves without rounded bounds.
Answer check(std::istream& grasp, std::istream& certificate, const QuestionOptions& options,
             const std::string& grasp_name = "grasp",
             const std::string& certificate_name = "certificate", bool exact_only = false);

}  // namespace stickslip_check
