// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A question about a grasp in space, with the parts of the file that whoever asks has
/// replaced.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/spatial_grasp.hpp"
#include "stickslip/equilibrium/question.hpp"

namespace stickslip {

/// What to replace, nothing by default.
struct SpatialOptions {
  std::optional<Vector6> wrench{};                      ///< applied to the object
  std::optional<Rational> preload{};                    ///< of every contact
  NormalLaw law = NormalLaw::kUnilateral;               ///< a file does not say; this does
  std::optional<Vector6> direction{};                   ///< of the load, of a margin
  std::optional<PreloadDirection> preload_direction{};  ///< of the preloads, of a margin
  std::optional<std::string> case_name{};  ///< of the file, whose wrench is applied
  Tolerances uncertain{};                  ///< of what is left when all is replaced
};

/// Is the grasp stable under its wrench, whatever its uncertain numbers are? Or, with a
/// direction, for which multiples is it (certificate/FORMAT.md, sections 1 and 7)?
struct SpatialQuestion {
  /// With everything replaced and widened, and no cases; the base of a margin.
  SpatialGrasp grasp;
  NormalLaw law = NormalLaw::kUnilateral;  ///< of every contact
  std::optional<Rational> preload{};       ///< set if it replaced the file's preloads
  std::string case_name{};                 ///< whose wrench it is; may be empty
  Tolerances uncertain{};                  ///< as asked
  WrenchBox wrench{};                      ///< before it was widened
  bool is_box = false;                     ///< as Question::box (equilibrium/question.hpp)
  std::optional<Vector6> direction{};      ///< as asked, of a margin
  std::optional<PreloadDirection> preload_direction{};  ///< as asked, of a margin
  std::vector<Rational> preload_growth{};  ///< P^u by contact; empty if no preload grows

  /// Whether it is about a margin.
  bool is_margin() const { return direction || preload_direction; }
};

/// The grasp and its load with what the options replace. Throws InputError as the question in
/// the plane does, and as GraspBox::widened() does.
SpatialQuestion ask(const SpatialGrasp& grasp, const SpatialOptions& options);

}  // namespace stickslip
