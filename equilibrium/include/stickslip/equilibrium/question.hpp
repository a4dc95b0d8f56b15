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
  Tolerances uncertain{};                  ///< of what is left when all is replaced
};

/// Is `loaded` stable under `law`? Or, with a direction, for which multiples is it, if load and
/// preloads grow from these by `growth`? With a record of how it came from a grasp file.
///
/// Or, if it is a *box* (certificate/FORMAT.md, section 6): is every grasp in it stable?
struct Question {
  /// With everything replaced; the base of a margin, the middle of a box.
  LoadedGrasp loaded;
  NormalLaw law = NormalLaw::kUnilateral;      ///< of every contact
  std::optional<Rational> preload;             ///< set if it replaced the file's preloads
  std::vector<ContactId> assumed_stiffness{};  ///< as in the GraspFile
  std::optional<Wrench> direction{};           ///< as asked, of a margin
  std::optional<PreloadDirection> preload_direction{};  ///< as asked, of a margin
  std::vector<Rational> preload_growth{};  ///< P^u by contact; empty if no preload grows
  std::string case_name{};                 ///< whose wrench it is; may be empty
  Tolerances uncertain{};                  ///< as asked
  /// With everything replaced and widened, if some interval has A < B, some normal a slope, or
  /// a contact that may have a preload a normal of irrational length.
  std::optional<GraspBox> box{};
  std::optional<WrenchBox> uncertain_wrench{};  ///< of a box whose file's w has intervals: w

  bool is_margin() const {
    return direction || preload_direction;
  }  ///< a family is asked about
};

/// The file's grasp and load with what the options replace; what a margin starts from is in
/// certificate/FORMAT.md, section 1: with a direction of the load no wrench, and with preloads
/// in proportion no preload. Throws InputError when something is not allowed, with the place
/// "preload", "direction" or "preload_direction"; and with the place "case" when the wrench of
/// a file with cases is needed and the options give neither one of them nor a wrench. Of a box
/// also as GraspBox::widened; and with the place "uncertain" if a margin is asked about.
Question ask(GraspFile file, const QuestionOptions& options);

/// \{ Of questions in the plane and in space: how much preloads grow, by those that there are
/// without it; that something grows; and that numbers are certain. Throw InputError as ask().
std::vector<Rational> preload_growth(const std::vector<Rational>& preloads,
                                     const PreloadDirection& direction);
void require_growth(bool load_grows, const std::vector<Rational>& growth,
                    const std::optional<PreloadDirection>& direction);
[[noreturn]] void refuse_uncertain_margin();
/// \}

/// What an engine answers; of a margin, the family. Throws InputError ("contacts[i].normal")
/// when a contact whose preload is not 0 or grows has a normal of irrational length, and if the
/// question is a box otherwise, about which decide_box() can be asked.
Problem problem_of(const Question& question);

}  // namespace stickslip
