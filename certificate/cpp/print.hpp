// SPDX-License-Identifier: MIT
/// \file
/// Answers as text.
#pragma once

#include <string>

#include "answer.hpp"

namespace stickslip_check {

/// One JSON object on a line, with the same keys whatever the answer; absent ones are null.
std::string as_json(const Answer& answer);

/// For people, in lines; for a Malformed, what is to be said on standard error. Every byte is
/// printable ASCII or ends a line.
std::string as_text(const Answer& answer);

}  // namespace stickslip_check
