// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What answers about margins in the plane and in space have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "question_options.hpp"

namespace stickslip {

/// The lines above the answer to a question about a margin.
std::string head_text(const Question& question, NumberText& text);

/// "[1, 5/4]", "from 15/4", "2".
std::string multiples_text(const Rational& low, const std::optional<Rational>& high,
                           NumberText& text);

/// With "and" before the last.
std::string joined(const std::vector<std::string>& parts);

}  // namespace stickslip
