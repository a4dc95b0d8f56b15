// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Writes JSON values as text.
#pragma once

#include <string>

namespace stickslip::core_detail {

/// Returns the decimal of a double, which reads back as the same double; "null" if it is not
/// finite.
std::string json_double(double value);

/// Appends a string as JSON writes it, quotes included. With `replaces`, bytes that are not
/// UTF-8 become U+FFFD; without it they throw JsonTextError.
void append_json_string(std::string& to, const std::string& text, bool replaces);

}  // namespace stickslip::core_detail
