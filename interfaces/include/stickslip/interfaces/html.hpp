// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The page itself, one text without anything to load.
#pragma once

#include <string>

#include "stickslip/core/number_text.hpp"

namespace stickslip {

/// Returns interfaces/page/web/page.html with the files that it includes, and the answer
/// (answer.hpp) as JSON in the element "answer". Scripts carry the `nonce` of a
/// Content-Security-Policy, if there is one.
std::string page_html(const Json& answer, const std::string& nonce = "");

/// Returns JSON that may stand in HTML: "<" is escaped.
std::string json_in_html(const Json& json);

}  // namespace stickslip
