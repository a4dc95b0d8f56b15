// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads numbers from words that somebody typed, and names the place of a wrong one.
#pragma once

#include <string>
#include <vector>

#include "stickslip/core/number.hpp"

namespace stickslip {

/// Returns the number that the text is. Throws InputError naming the place.
Rational rational_at(const std::string& place, const std::string& text);

/// Returns the numbers of "P0,P1,...". Throws InputError naming the place.
std::vector<Rational> rationals_at(const std::string& place, const std::string& text);

}  // namespace stickslip
