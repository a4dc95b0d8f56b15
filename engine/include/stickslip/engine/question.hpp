// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A question about the grasp of a file: options may replace some numbers of the file first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// How preloads grow with the multiple of a margin: all in proportion, or each at a rate of its
/// own.
struct PreloadDirection {
  /// Whether preloads and forces of springs scale: at multiple l each is l times the given one,
  /// so that there is none at 0.
  bool scale = false;
  /// Growth::preloads, each >= 0 for contacts and ratchets; empty if `scale` is set.
  std::vector<Rational> preloads{};
};

/// The options of a question: the numbers to replace, none by default, and the directions of a
/// margin if one is asked for.
struct QuestionOptions {
  std::optional<RationalRow> wrench{};     ///< the wrench applied to the object
  std::optional<Rational> preload{};       ///< the preload of every contact
  NormalLaw law = NormalLaw::kUnilateral;  ///< the normal law (NormalLaw)
  std::optional<RationalRow> direction{};  ///< the direction of the load of a margin
  std::optional<PreloadDirection> preload_direction{};  ///< the direction of its preloads
  std::optional<std::string> case_name{};  ///< the case of the file whose wrench is applied
  Tolerances uncertain{};  ///< tolerances that widen the numbers, replaced ones too
  std::optional<MotionBound> max_motion{};  ///< replaces the file's bound on motions
  /// Whether forces may be limited (UncertainContact::max_force), as for statics alone. A
  /// contact that yields at its limit is none of the law that all others decide by.
  bool takes_limits = false;
};

/// A question, and how it came from a grasp file. It asks one of three things:
///
/// - Is the one `grasp`, in the plane or in space, stable under `law`?
/// - If there is a direction, it asks about a *margin*: for which multiples l >= 0 is the grasp
///   stable with its load and preloads plus l times their directions?
/// - If numbers are uncertain (certificate/FORMAT.md, section 6): is every grasp in the box
///   stable?
struct Question {
  /// The grasp with everything replaced and widened; for a margin, with the load and preloads
  /// at multiple 0. A grasp of one body in the plane is kept as a LoadedGrasp, and all others
  /// as a GraspBox. It is a GraspBox in the plane, too, if a number is an interval, a normal
  /// has a slope, there is a ball of loads, motions are bounded, or a contact whose preload is
  /// not 0 or grows has a normal of irrational length.
  AnyGrasp grasp;
  NormalLaw law = NormalLaw::kUnilateral;  ///< the law of every contact
  std::optional<Rational> preload{};       ///< set if it replaced the file's preloads
  /// The contacts for which the file gave no stiffness, so that 1 is assumed.
  std::vector<ContactId> assumed_stiffness{};
  std::optional<RationalRow> direction{};               ///< the direction of a margin's load
  std::optional<PreloadDirection> preload_direction{};  ///< the direction of its preloads
  /// Growth::preloads, which follow from preload_direction; empty without one.
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
  /// Returns whether this is a margin that is answered by claims: ranges of multiples, each
  /// proved stable or unstable, between which some may stay unsettled (certificate/FORMAT.md,
  /// section 5). That is so where the grasp is kept as a GraspBox. For a LoadedGrasp the
  /// multiples that are resisted are found exactly instead.
  bool has_claims() const { return is_margin() && box() != nullptr; }
  /// Returns the name, units, and outline or surface of the grasp.
  const GraspDescription& description() const { return grasp.description(); }
  /// Returns the grasp of a question about one grasp in the plane. Throws ContractError for any
  /// other.
  const LoadedGrasp& loaded() const { return grasp.loaded(); }
  /// Returns the box, or nullptr if the grasp is a LoadedGrasp, a single one in the plane.
  const GraspBox* box() const { return grasp.box(); }
};

/// Returns the grasp of a box in its simplest form. That is a LoadedGrasp if the box is one
/// body in the plane, has certain numbers and no bound on motions, and no contact whose preload
/// is not 0 or grows has a normal of irrational length. Else it is the box itself. `growth` has
/// the rate of each preload; it is empty if none grows.
AnyGrasp simplest(GraspBox box, const std::vector<Rational>& growth = {});

/// Returns the question about the file's grasp and load with what the options replace. A margin
/// with a direction of the load leaves the file's own wrench out: its load grows from 0, unless
/// the options give a wrench or a case. A margin whose preloads scale begins without preloads
/// (certificate/FORMAT.md, section 1).
///
/// Throws InputError
/// - with the place "wrench", "preload", "direction" or "preload_direction" if that option is
///   not allowed;
/// - with the place "case" if the options give both a case and a wrench, name a case that the
///   file does not have, or give neither where the wrench of a file with cases is needed;
/// - with the place "uncertain" if a margin is asked about and some number is an interval;
/// - at the limit of a force, unless the options take these;
/// - as GraspBox::widened() does for tolerances, and bound_of() for a bound on motions.
Question ask(GraspFile file, const QuestionOptions& options = {});

/// Throws InputError if a number is uncertain, so that the question is about more than one grasp.
void require_one_grasp(const Question& question);

/// Returns the same question without a bound of motions.
Question without_bound(Question question);

/// Returns the same question without the mechanism, if that is one body that moves freely, and
/// there is no spring and no torsion. Else it returns the question as it is. Certificates about
/// the file still need the form for several bodies.
Question as_one_body(Question question);

/// \{ Throws InputError if there are several bodies, and says that `what` is for one body only.
void require_one_body(const AnyGrasp& grasp, const std::string& what);
inline void require_one_body(const Question& question, const std::string& what) {
  require_one_body(question.grasp, what);
}
/// \}

/// Returns the exact problem in the plane; for a margin the family of problems, one for each
/// multiple. Throws InputError at "contacts[i].normal" if a contact whose preload is not 0 or
/// grows has a normal of irrational length. Throws InputError, too, for several bodies, bounded
/// motions, a grasp in space, and uncertain numbers. decide_box() answers what is refused here,
/// but for margins.
Problem problem_of(const Question& question);

}  // namespace stickslip
