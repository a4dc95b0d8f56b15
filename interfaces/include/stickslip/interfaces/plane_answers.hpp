// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Regions, found and proved, as `region --json` prints them, and maps as `map --json` does.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "stickslip/measures/map.hpp"
#include "stickslip/measures/region_proof.hpp"

namespace stickslip {

/// What is resisted in a plane of wrenches.
struct RegionAnswer {
  Question question;                     ///< its wrench plays no part
  WrenchPlane plane;                     ///< of the wrenches
  ResistibleSet found{};                 ///< with pieces, if they were asked for
  ResistibleWork work{};                 ///< to find it
  std::optional<Undecided> undecided{};  ///< at a limit; then nothing else is known
};

/// How far to go, and whom to tell.
struct RegionOptions {
  ResistibleOptions modes;   ///< of the region
  RegionProofOptions proof;  ///< of the certificate
};

/// Finds the region.
RegionAnswer answer_to(Question question, const WrenchPlane& plane,
                       const RegionOptions& options = {});

/// What `region --json` prints, before finished().
Json to_json(const RegionAnswer& answer);

/// Proves it: the certificate of a region that is known, or the limit at which there is none.
std::variant<std::string, Undecided> certificate_of(const RegionAnswer& answer,
                                                    const RegionOptions& options = {});

/// The cells of a map over these axes, before finished().
Json map_json(const Question& question, const MapAxis& x, const MapAxis& y,
              const std::vector<MapCell>& cells);

/// A window of a plane of loads that is looked at cell by cell.
struct LoadWindow {
  GraspBox grasp;      ///< with the origin as its load
  RationalRow origin;  ///< of the plane: its loads are origin + s u + t v
  MapAxis s;           ///< along u
  MapAxis t;           ///< along v
};

/// The window as far either way as all preloads together, a size at which friction ends; or 1.
/// Requires a box that is one grasp; origin, u and v have as many components as its load.
LoadWindow load_window(const Question& question, RationalRow origin, RationalRow u,
                       RationalRow v);

/// What `region --json` prints of a window, before finished().
Json region_json(const Question& question, const LoadWindow& plane,
                 const std::vector<MapCell>& cells);

}  // namespace stickslip
