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

/// How the preloads grow with the multiple of a margin: all in proportion, or each by a number
/// of its own.
struct PreloadDirection {
  bool scale = false;             ///< all in proportion: the base is no preload
  std::vector<Rational> rates{};  ///< unless scale: by contact, >= 0; the base is as given
};

/// What to replace, nothing by default; and the directions of a margin, if one is asked for.
struct QuestionOptions {
  std::optional<Wrench> wrench{};                       ///< applied to the object
  std::optional<Rational> preload{};                    ///< of every contact
  NormalLaw law = NormalLaw::kUnilateral;               ///< a file does not say; this does
  std::optional<Wrench> direction{};                    ///< of the load
  std::optional<PreloadDirection> preload_direction{};  ///< of the preloads
  std::optional<std::string> case_name{};  ///< of the file, whose wrench is applied
};

/// Is `loaded` stable under `law`? Or, with a direction, for which multiples is it, if load and
/// preloads grow from these by `growth`? With a record of how it came from a grasp file.
struct Question {
  LoadedGrasp loaded;                      ///< with everything replaced; the base of a margin
  NormalLaw law = NormalLaw::kUnilateral;  ///< of every contact
  std::optional<Rational> preload;         ///< set if it replaced the file's preloads
  std::vector<ContactId> assumed_stiffness{};           ///< as in the GraspFile
  std::optional<Wrench> direction{};                    ///< as asked, of a margin
  std::optional<PreloadDirection> preload_direction{};  ///< as asked, of a margin
  std::vector<Rational> preload_growth{};  ///< P^u by contact; empty if no preload grows
  std::string case_name{};                 ///< whose wrench it is; may be empty

  bool is_margin() const {
    return direction || preload_direction;
  }  ///< a family is asked about
};

/// The file's grasp and load with what the options replace; what a margin starts from is in
/// certificate/FORMAT.md, section 1: with a direction of the load no wrench, and with preloads
/// in proportion no preload. Throws InputError when something is not allowed, with the place
/// "preload", "direction" or "preload_direction"; and with the place "case" when the wrench of
/// a file with cases is needed and the options give neither one of them nor a wrench.
Question ask(const GraspFile& file, const QuestionOptions& options);

/// What an engine answers; of a margin, the family. Throws InputError ("contacts[i].normal")
/// when a contact whose preload is not 0 or grows has a normal of irrational length.
Problem problem_of(const Question& question);

}  // namespace stickslip
