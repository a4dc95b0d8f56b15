// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Small tables of text for people.
#pragma once

#include <string>
#include <vector>

namespace stickslip {

/// Numbers go to the right, words to the left.
enum class Align { kLeft, kRight };

/// Lines of aligned columns, two blanks apart; the first row is the heading.
std::string format_table(const std::vector<std::vector<std::string>>& rows,
                         Align align = Align::kRight);

}  // namespace stickslip
