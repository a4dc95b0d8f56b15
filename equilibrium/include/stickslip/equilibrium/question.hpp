// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A question about a grasp file, with the parts of the file that whoever asks has replaced.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/grasp_file.hpp"
#include "stickslip/equilibrium/problem.hpp"

namespace stickslip {

/// What to replace; nothing by default.
struct QuestionOptions {
  std::optional<Wrench> wrench;            ///< applied to the object
  std::optional<Rational> preload;         ///< of every contact
  NormalLaw law = NormalLaw::kUnilateral;  ///< a file does not say; this does
};

/// Is `loaded` stable under `law`? With a record of how it came from a grasp file.
struct Question {
  LoadedGrasp loaded;                          ///< with everything replaced
  NormalLaw law = NormalLaw::kUnilateral;      ///< of every contact
  std::optional<Rational> preload;             ///< set if it replaced the file's preloads
  std::vector<ContactId> assumed_stiffness{};  ///< as in the GraspFile
};

/// The file's grasp and load with what the options replace. Throws InputError when a
/// replacement is not allowed (a negative preload).
Question ask(const GraspFile& file, const QuestionOptions& options);

}  // namespace stickslip
