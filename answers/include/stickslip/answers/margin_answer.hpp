// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Margins as `margin --json` prints them.
#pragma once

#include <optional>

#include "stickslip/answers/verdict_answer.hpp"
#include "stickslip/margin/margin.hpp"
#include "stickslip/margin/spatial_margin.hpp"

namespace stickslip {

/// \{ Before finished().
Json margin_json(const Question& question, const Margin& margin, const MarginWork& work,
                 const Warnings& warnings);
Json margin_json(const Question& question, const SpatialMargin& margin,
                 const Warnings& warnings);
/// \}

/// The least multiple that is resisted, if there is one.
std::optional<Rational> least(const Margin& margin);

}  // namespace stickslip
