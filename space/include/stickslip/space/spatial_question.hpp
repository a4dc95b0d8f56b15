// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A question about a grasp in space, with the parts of the file that whoever asks has
/// replaced.
#pragma once

#include <optional>
#include <string>

#include "stickslip/core/spatial_grasp.hpp"

namespace stickslip {

/// What to replace, nothing by default.
struct SpatialOptions {
  std::optional<Vector6> wrench{};         ///< applied to the object
  std::optional<Rational> preload{};       ///< of every contact
  NormalLaw law = NormalLaw::kUnilateral;  ///< a file does not say; this does
  std::optional<std::string> case_name{};  ///< of the file, whose wrench is applied
  Tolerances uncertain{};                  ///< of what is left when all is replaced
};

/// Is the grasp stable under its wrench, whatever its uncertain numbers are?
struct SpatialQuestion {
  SpatialGrasp grasp;                      ///< with everything replaced and widened; no cases
  NormalLaw law = NormalLaw::kUnilateral;  ///< of every contact
  std::optional<Rational> preload{};       ///< set if it replaced the file's preloads
  std::string case_name{};                 ///< whose wrench it is; may be empty
  Tolerances uncertain{};                  ///< as asked
  SpatialWrench wrench{};                  ///< before it was widened
  bool is_box = false;                     ///< as Question::box (equilibrium/question.hpp)
};

/// The grasp and its load with what the options replace. Throws InputError with the place
/// "case" as ask() does, "preload" for one below 0, and as widened() does.
SpatialQuestion ask(const SpatialGrasp& grasp, const SpatialOptions& options);

}  // namespace stickslip
