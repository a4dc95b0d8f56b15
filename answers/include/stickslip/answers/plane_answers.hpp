// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Regions and maps as `region --json` and `map --json` print them.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/box/map.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/equilibrium/question.hpp"
#include "stickslip/resistance/resistible_set.hpp"

namespace stickslip {

/// What is resisted in a plane of wrenches.
struct RegionReport {
  std::vector<ResistiblePiece> pieces;   ///< by contact mode; may be left out
  PlaneUnion region;                     ///< the union of all pieces
  ResistibleWork work;                   ///< to find them
  std::optional<Undecided> undecided{};  ///< if a limit was reached; then nothing else is known
};

/// Before finished().
Json region_json(const Question& question, const WrenchPlane& plane,
                 const RegionReport& report);

/// The cells of a map over these axes, before finished().
Json map_json(const Question& question, const MapAxis& x, const MapAxis& y,
              const std::vector<MapCell>& cells);

}  // namespace stickslip
