// SPDX-License-Identifier: MIT
/// \file
/// Answers on standard output.
#pragma once

#include "answer.hpp"

namespace stickslip_check {

/// One JSON object on a line, with the same keys whatever the answer; absent ones are null.
void print_json(const Answer& answer);

/// For people.
void print(const Accepted& accepted);
void print(const Rejected& rejected);

}  // namespace stickslip_check
