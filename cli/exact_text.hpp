// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact numbers and what was asked, as the subcommands print them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "stickslip/equilibrium/question.hpp"

namespace stickslip {

using Json = nlohmann::ordered_json;

/// "(1, -1/2)"; long numbers as to_readable_string gives them.
std::string tuple(const Vector2& v);
std::string tuple(const Vector3& v);
std::string tuple(const Twist& d);

/// The same with long numbers rounded to six digits, as in "(1, ~0.333333)"; for sentences.
std::string brief(const Rational& value);
std::string brief(const Vector2& v);
std::string brief(const Twist& d);

/// ["1", "-1/2"].
Json strings_json(const Vector2& v);
Json strings_json(const Vector3& v);

/// The normals that were snapped; an array, or a line for each.
Json snapped_json(const Question& question);
std::string snapped_text(const Question& question);

}  // namespace stickslip
