// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Loads that are balanced as a box is on its edge (docs/model.md): one that differs by a
/// billionth is not.
#pragma once

#include <optional>
#include <string>

#include "stickslip/core/box.hpp"

namespace stickslip::warnings_detail {

/// \{ Thresholds: how many contacts are looked at, and which part of the load counts as
/// rounding.
inline constexpr std::size_t kMostContactsInBalance = 64;
inline constexpr long kRoundingPart = 1000000000;
/// \}

/// Returns the warning that a motion exists that no contact opposes, whatever the stiffness,
/// and on which the load does next to no work. Some load that differs by that little does work
/// on it, and so is held by no forces. Returns nothing if there are springs, no load or many
/// contacts. Requires one grasp that is stable.
/// Takes one exact linear program, with a row for each coordinate and 2 variables for each
/// contact, in space 4.
std::optional<std::string> balance_on_an_edge(const AnyGrasp& grasp);

}  // namespace stickslip::warnings_detail
