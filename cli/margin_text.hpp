// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What answers about margins in the plane and in space have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "question_options.hpp"

namespace stickslip {

/// What of a margin's question is shown.
struct FamilyText {
  std::string heading;
  std::string wrench;                    ///< w
  std::optional<std::string> direction;  ///< u
  std::optional<PreloadDirection> preload_direction;
  std::vector<Rational> preloads;  ///< P, or where they grow in proportion P^u
  std::vector<Rational> growth;    ///< P^u
};

/// The lines above the answer.
std::string head_text(const FamilyText& family, NumberText& text);

/// "[1, 5/4]", "from 15/4", "2".
std::string multiples_text(const Rational& low, const std::optional<Rational>& high,
                           NumberText& text);

/// With "and" before the last.
std::string joined(const std::vector<std::string>& parts);

}  // namespace stickslip
