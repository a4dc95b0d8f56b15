// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A question about a grasp file in which whoever asks may have replaced some numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// The growth of preloads with the multiple of a margin: all in proportion, or each at a rate
/// of its own.
struct PreloadDirection {
  /// Whether preloads scale: the preload at multiple l is l times the given one, so that there
  /// is none at 0.
  bool scale = false;
  /// How much the preload of each contact, and then the force of each spring, grows per unit of
  /// l, from what is given. It is >= 0 for contacts and ratchets, and empty if `scale` is set.
  std::vector<Rational> rates{};
};

/// The numbers to replace, none by default, and the directions of a margin if one is asked for.
struct QuestionOptions {
  std::optional<RationalRow> wrench{};     ///< applied to the object
  std::optional<Rational> preload{};       ///< the preload of every contact
  NormalLaw law = NormalLaw::kUnilateral;  ///< the normal law (NormalLaw)
  std::optional<RationalRow> direction{};  ///< the direction of the load of a margin
  std::optional<PreloadDirection> preload_direction{};  ///< the direction of its preloads
  std::optional<std::string> case_name{};  ///< the case of the file whose wrench is applied
  Tolerances uncertain{};  ///< tolerances of the numbers that result from all this
  std::optional<MotionBound> max_motion{};  ///< replaces the file's bound on motions
};

/// A question: is the grasp, in the plane or in space, stable under `law`? With a direction, a
/// margin: for which multiples is it stable, if load and preloads grow from these by multiples
/// of their directions? The question records how it came from a grasp file.
///
/// If the grasp is a *box* (certificate/FORMAT.md, section 6): is every grasp in it stable?
struct Question {
  /// The grasp with everything replaced and widened; the base of a margin. A grasp of one body
  /// in the plane is a LoadedGrasp, except in these cases, in which it is a box: a number is an
  /// interval, a normal has a slope, there is a ball of loads, motions are bounded, or a
  /// contact whose preload is not 0 or grows has a normal of irrational length.
  AnyGrasp grasp;
  NormalLaw law = NormalLaw::kUnilateral;  ///< the law of every contact
  std::optional<Rational> preload{};       ///< set if it replaced the file's preloads
  /// The contacts for which the file gave no stiffness, so that 1 is assumed.
  std::vector<ContactId> assumed_stiffness{};
  std::optional<RationalRow> direction{};               ///< the direction of a margin's load
  std::optional<PreloadDirection> preload_direction{};  ///< the direction of its preloads
  /// P^u, the growth per unit of l that follows from preload_direction, by element: contacts,
  /// then springs; empty if no preload grows.
  std::vector<Rational> preload_growth{};
  std::string case_name{};                     ///< the case whose wrench this is; may be empty
  Tolerances uncertain{};                      ///< the tolerances that were asked for
  std::optional<WrenchBox> wrench_as_asked{};  ///< the wrench before a tolerance widened it

  /// Returns whether the question is about a margin.
  bool is_margin() const { return direction || preload_direction; }
  /// Returns whether the grasp is in space, whose points have three coordinates.
  bool in_space() const { return grasp.in_space(); }
  /// Returns the mechanism of several bodies; null if there is one body.
  const Mechanism* mechanism() const { return grasp.mechanism(); }
  /// Returns whether motions are bounded, which GraspBox::max_motion says.
  bool is_bounded() const { return grasp.is_bounded(); }
  /// Returns whether this is a margin whose answer is a list of ranges of multiples, each
  /// proved stable or unstable, which may leave some unsettled (certificate/FORMAT.md, section
  /// 5). If the grasp is no box, the multiples that are resisted are known exactly instead.
  bool has_claims() const { return is_margin() && box() != nullptr; }
  /// Returns whether there is one body, in the plane. Some functions, such as problem_of(),
  /// accept no other.
  bool is_one_planar_body() const { return grasp.is_one_planar_body(); }
  /// Returns the name, outline and units of the grasp.
  const GraspDescription& description() const { return grasp.description(); }
  /// Returns the grasp of a question about one grasp in the plane. Throws ContractError for any
  /// other.
  const LoadedGrasp& loaded() const;
  /// Returns the box, or nullptr if the grasp is a LoadedGrasp, a single one in the plane.
  const GraspBox* box() const { return grasp.box(); }
};

/// Returns the box, or one grasp in the plane if that is all it is: one body, certain numbers,
/// no bound on motions, and no irrational length of a normal whose contact has a preload, or
/// whose preload grows. `growth` is that of preloads; it is empty if none grows.
AnyGrasp simplest(GraspBox box, const std::vector<Rational>& growth = {});

/// Returns the question about the file's grasp and load with what the options replace. A margin
/// with a direction of the load leaves the file's own wrench out: its load grows from 0, unless
/// the options give a wrench or a case. A margin with preloads in proportion begins with no
/// preload (certificate/FORMAT.md, section 1).
///
/// Throws InputError with the place "wrench", "preload", "direction" or "preload_direction" if
/// one of these is not allowed; with the place "case" if the wrench of a file with cases is
/// needed and the options give neither a case nor a wrench; with the place "uncertain" if a
/// margin is asked about and some number is an interval. It throws also as GraspBox::widened
/// does for tolerances, and bound_of() for a bound on motions.
Question ask(GraspFile file, const QuestionOptions& options = {});

/// Throws InputError unless the question is about one grasp. For one body in the plane it
/// throws whenever problem_of() does; for all others only if a number is uncertain.
void require_one_grasp(const Question& question);

/// Returns the same question without a bound of motions.
Question without_bound(Question question);

/// Returns the same question about a grasp of one body if that is all that a mechanism is: a
/// body that moves freely, with contacts of the ground alone and without torsion. Certificates
/// about the file still speak of several bodies.
Question as_one_body(Question question);

/// \{ Throws InputError if there are several bodies, and says that `what` is for one body only.
void require_one_body(const AnyGrasp& grasp, const std::string& what);
inline void require_one_body(const Question& question, const std::string& what) {
  require_one_body(question.grasp, what);
}
/// \}

/// Returns the exact problem in the plane; for a margin the family of problems, one for each
/// multiple. Throws
/// InputError at "contacts[i].normal" if a contact whose preload is not 0 or grows has a normal
/// of irrational length. Throws InputError, too, for several bodies, bounded motions, a grasp
/// in space, and uncertain numbers; decide_box() answers about these.
Problem problem_of(const Question& question);

}  // namespace stickslip
