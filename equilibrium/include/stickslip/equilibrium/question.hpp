// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A question about a grasp file, with the parts of the file that whoever asks has replaced.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/equilibrium/problem.hpp"

namespace stickslip {

/// What to replace; nothing by default.
struct QuestionOptions {
  std::optional<Wrench> wrench;
  std::optional<Rational> preload;  ///< of every contact
  std::optional<Rational> snap_tolerance;
  NormalLaw law = NormalLaw::kUnilateral;
};

struct Question {
  LoadedGrasp loaded;  ///< with everything replaced
  NormalLaw law = NormalLaw::kUnilateral;
  std::optional<Rational> preload;  ///< set if it replaced the file's preloads
  std::vector<SnappedNormal> snapped;
};

/// Throws InputError when a replacement is not allowed (a negative preload, a tolerance not in
/// (0, 1)).
Question ask(const GraspFile& file, const QuestionOptions& options);

}  // namespace stickslip
