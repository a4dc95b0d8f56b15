// SPDX-License-Identifier: MIT
/// \file
/// The checker as a function: does this certificate prove its verdict about this question?
/// Only FORMAT.md, beside this folder, is trusted to define what that means; nothing of the
/// certificate is, and no solver takes part.
#pragma once

#include <istream>
#include <string>

#include "answer.hpp"

namespace stickslip_check {

/// Reads both files and answers (FORMAT.md §8). The names are for messages. Throws nothing but
/// what the machine does (no memory).
Answer check(std::istream& grasp, std::istream& certificate, const Options& options,
             const std::string& grasp_name = "grasp",
             const std::string& certificate_name = "certificate");

/// "unilateral" or "bilateral".
std::string law_name(bool bilateral);

}  // namespace stickslip_check
