// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The numbers of a box as text for people.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "stickslip/answers/uncertain_numbers.hpp"

namespace stickslip {

/// The load w, of which components may be intervals, "[-1, 1]".
std::string load_text(const WrenchBox& load, NumberText& text);

/// Which lengths are irrational, and what stands in their place; nothing for no contacts.
std::string enclosure_text(const std::vector<std::size_t>& contacts, unsigned bits,
                           bool proved);

/// A table of them and a line below; nothing if there are none.
std::string uncertain_text(const std::vector<UncertainNumber>& numbers, NumberText& text);

/// The first rows of a table, its heading not counted.
std::string short_table(std::vector<std::vector<std::string>> rows);

}  // namespace stickslip
