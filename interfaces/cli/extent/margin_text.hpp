// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The common text of answers about margins in the plane and in space.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "question_options.hpp"

namespace stickslip {

/// Returns the lines above the answer to a question about a margin.
std::string head_text(const Question& question, NumberText& text);

/// Returns "[1, 5/4]", "from 15/4" or "2".
std::string multiples_text(const Rational& low, const std::optional<Rational>& high,
                           NumberText& text);

/// Returns the parts with "and" before the last.
std::string joined(const std::vector<std::string>& parts);

}  // namespace stickslip
