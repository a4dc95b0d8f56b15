// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Answers about margins in words.
#pragma once

#include <optional>

#include "question_options.hpp"
#include "stickslip/interfaces/margin_answer.hpp"

namespace stickslip {

/// \{ Print the answer to a question about a margin that is exact, or that is a list of claims.
void print_text(const Question& question, const Margin& margin, NumberText& text);
void print_text(const Question& question, const SpatialMargin& margin,
                const std::optional<SecondMargin>& within, NumberText& text);
/// \}

/// \{ Print the least multiple that is resisted.
void print_least(const Margin& margin, NumberText& text);
void print_least(const SpatialMargin& margin, NumberText& text);
/// \}

}  // namespace stickslip
