// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Texts of JSON values.
#pragma once

#include <string>

namespace stickslip::core_detail {

/// The decimal of a double, which reads back as the same; "null" if it is not finite.
std::string json_double(double value);

/// Appends a string as JSON writes it, quotes included. What is not UTF-8 becomes U+FFFD if
/// `replaces`; else it throws JsonTextError.
void append_json_string(std::string& to, const std::string& text, bool replaces);

}  // namespace stickslip::core_detail
