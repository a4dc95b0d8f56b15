// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A question about a grasp file, with the parts of the file that whoever asks has replaced.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// How the preloads grow with the multiple of a margin: all in proportion, or each by a number
/// of its own.
struct PreloadDirection {
  bool scale = false;             ///< all in proportion: the base is no preload
  std::vector<Rational> rates{};  ///< unless scale: by contact, >= 0; the base is as given
};

/// What to replace, nothing by default; and the directions of a margin, if one is asked for.
struct QuestionOptions {
  std::optional<RationalRow> wrench{};                  ///< applied to the object
  std::optional<Rational> preload{};                    ///< of every contact
  NormalLaw law = NormalLaw::kUnilateral;               ///< a file does not say; this does
  std::optional<RationalRow> direction{};               ///< of the load
  std::optional<PreloadDirection> preload_direction{};  ///< of the preloads
  std::optional<std::string> case_name{};   ///< of the file, whose wrench is applied
  Tolerances uncertain{};                   ///< of what is left when all is replaced
  std::optional<MotionBound> max_motion{};  ///< in place of the file's
};

/// Is the grasp, in the plane or in space, stable under `law`? Or, with a direction, for which
/// multiples is it, if load and preloads grow from these by `growth`? With a record of how it
/// came from a grasp file.
///
/// Or, if it is a *box* (certificate/FORMAT.md, section 6): is every grasp in it stable?
struct Question {
  /// With everything replaced and widened; the base of a margin. In the plane a box if some
  /// interval has A < B, some normal a slope, motions are bounded, or a contact that may have a
  /// preload, or whose preload grows, has a normal of irrational length.
  AnyGrasp grasp;
  NormalLaw law = NormalLaw::kUnilateral;      ///< of every contact
  std::optional<Rational> preload{};           ///< set if it replaced the file's preloads
  std::vector<ContactId> assumed_stiffness{};  ///< as in the GraspFile
  std::optional<RationalRow> direction{};      ///< as asked, of a margin
  std::optional<PreloadDirection> preload_direction{};  ///< as asked, of a margin
  std::vector<Rational> preload_growth{};      ///< P^u by contact; empty if no preload grows
  std::string case_name{};                     ///< whose wrench it is; may be empty
  Tolerances uncertain{};                      ///< as asked
  std::optional<WrenchBox> wrench_as_asked{};  ///< before it was widened, if it was

  /// A family is asked about.
  bool is_margin() const { return direction || preload_direction; }
  bool in_space() const { return stickslip::in_space(grasp); }  ///< of three coordinates
  /// Of several bodies; null: of one.
  const Mechanism* mechanism() const { return mechanism_of(grasp); }
  /// Whether motions are bounded: only then by GraspBox::max_motion.
  bool is_bounded() const { return box() != nullptr && box()->is_bounded(); }
  /// Whether a margin is a list of claims (certificate/FORMAT.md, section 5), and not exactly
  /// what is resisted: unless it is about one grasp in the plane.
  bool has_claims() const { return is_margin() && box() != nullptr; }
  /// Of one body in the plane, for which there is more than for all others.
  bool is_one_planar_body() const { return !in_space() && mechanism() == nullptr; }
  /// Name, outline and units of the grasp.
  const GraspDescription& description() const { return description_of(grasp); }
  /// Requires one grasp in the plane.
  const LoadedGrasp& loaded() const;
  /// All that `grasp` may be unless it is one in the plane, which is nullptr.
  const GraspBox* box() const { return std::get_if<GraspBox>(&grasp); }
};

/// The file's grasp and load with what the options replace; what a margin starts from is in
/// certificate/FORMAT.md, section 1: with a direction of the load no wrench, and with preloads
/// in proportion no preload. Throws InputError when something is not allowed, with the place
/// "wrench", "preload", "direction" or "preload_direction"; and with the place "case" when the
/// wrench of a file with cases is needed and the options give neither one of them nor a wrench.
/// Of a box also as GraspBox::widened; and with the place "uncertain" if a margin is asked
/// about.
Question ask(GraspFile file, const QuestionOptions& options);

/// Throws InputError unless the question is about one grasp: in the plane as problem_of(), in
/// space where numbers are uncertain.
void require_one_grasp(const Question& question);

/// The same question about all motions.
Question without_bound(Question question);

/// \{ Throws InputError if there are several bodies: `what` is not done for them.
void require_one_body(const AnyGrasp& grasp, const std::string& what);
inline void require_one_body(const Question& question, const std::string& what) {
  require_one_body(question.grasp, what);
}
/// \}

/// What an engine in the plane answers; of a margin, the family. Throws InputError
/// ("contacts[i].normal") when a contact whose preload is not 0 or grows has a normal of
/// irrational length; if the question is a box otherwise, about which decide_box() can be
/// asked; in space; and of several bodies.
Problem problem_of(const Question& question);

}  // namespace stickslip
