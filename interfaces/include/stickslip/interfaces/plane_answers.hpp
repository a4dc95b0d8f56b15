// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The regions of `region --json`, found and proved, the maps of `map --json`, and the slip
/// states of `states --json`.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "stickslip/measures/map.hpp"
#include "stickslip/measures/region_proof.hpp"

namespace stickslip {

/// The resisted loads of a plane of wrenches.
struct RegionAnswer {
  Question question;                     ///< its wrench plays no part
  WrenchPlane plane;                     ///< the plane of the wrenches
  ResistibleSet found{};                 ///< with pieces, if they were asked for
  ResistibleWork work{};                 ///< the work to find the set
  std::optional<Undecided> undecided{};  ///< set at a limit; then nothing else is known
};

/// The limits of a region and of its proof, and who hears of their progress.
struct RegionOptions {
  ResistibleOptions modes;   ///< the options of the region
  RegionProofOptions proof;  ///< the options of the certificate
};

/// Finds the region.
RegionAnswer region_answer(Question question, const WrenchPlane& plane,
                           const RegionOptions& options = {});

/// Returns the output of `region --json`, before finished().
Json to_json(const RegionAnswer& answer);

/// Returns the certificate of a region that is known, or the limit at which there is none.
std::variant<std::string, Undecided> certificate_of(const RegionAnswer& answer,
                                                    const RegionOptions& options = {});

/// Returns the cells of a map over these axes, before finished().
Json map_json(const Question& question, const MapAxis& x, const MapAxis& y,
              const std::vector<MapCell>& cells);

/// A window of a plane of loads that is looked at cell by cell.
struct LoadWindow {
  GraspBox grasp;      ///< the grasp with the origin as its load
  RationalRow origin;  ///< the origin of the plane, whose loads are origin + s u + t v
  MapAxis s;           ///< the axis along u
  MapAxis t;           ///< the axis along v
};

/// Returns the window that goes as far either way as the sum of all preloads, a size at which
/// friction ends; or 1 if that is 0. Requires a box that is one grasp; origin, u and v have as
/// many components as its load.
LoadWindow load_window(const Question& question, RationalRow origin, RationalRow u,
                       RationalRow v);

/// Returns the output of `region --json` for a window, before finished().
Json region_json(const Question& question, const LoadWindow& plane,
                 const std::vector<MapCell>& cells);

/// Returns the counts of cells, and the slip states if they were listed.
Json states_json(const Enumeration& found, bool listed);

}  // namespace stickslip
