// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Margins as `margin --json` prints them.
#pragma once

#include <functional>
#include <optional>

#include "stickslip/interfaces/verdict_answer.hpp"
#include "stickslip/measures/margin.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

/// Returns "scale", or how much each preload grows.
Json preload_direction_json(const PreloadDirection& direction);

/// \{ Return the output of `margin --json`, before finished().
Json margin_json(const Question& question, const Margin& margin, const MarginWork& work,
                 const Warnings& warnings);
Json margin_json(const Question& question, const SpatialMargin& margin,
                 const Warnings& warnings);
/// \}

/// The margin beside one that only the rounding of the data decides.
struct SecondMargin {
  Question question;     ///< the question with a bound on motions, or another direction
  SpatialMargin margin;  ///< its answer
};

/// Returns the second answer beside the margin of a question, or nothing if that says all that
/// matters. If far motions ended the search, it is the margin within 1000 times the natural
/// motion (natural_bound()). If the direction differs from the nearest one that no free motion
/// sees by a part of less than 1e-12 of it, it is the margin along that one. Calls `progress`
/// as find_spatial_margin() does.
std::optional<SecondMargin> margin_within(
    const Question& question, const SpatialMargin& margin, const SpatialMarginOptions& options,
    const std::function<void(const SpatialMargin&)>& progress = {});

/// Adds the second answer to what margin_json() returned.
void add_within(Json& json, const SecondMargin& within);

/// Returns the least multiple that is resisted, if there is one.
std::optional<Rational> least(const Margin& margin);

}  // namespace stickslip
