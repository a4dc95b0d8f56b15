// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The judgement of another program's answer against the exact one.
///
/// A *claim* says of a question (engine/question.hpp) "stable" or "unstable", and may add the
/// motion and the forces that were found. It is judged exactly, by three questions:
///
/// - Is the verdict right? If not, how far is the load from one for which it would be: is this
///   a wrong answer, or a *tie* that no double-precision program can be expected to see?
/// - By how much does the claimed solution miss each condition of problem.hpp, or in space of
///   certificate/FORMAT.md, section 1?
/// - Is there an exact equilibrium of the same kind nearby?
///
/// Frames and signs are those of the question: forces are those of the contacts on the object,
/// in the object frame, under the wrench that is applied to the object.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/core/root_sum.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {

/// Another program's answer to a question. Vectors have the coordinates of the grasp: twists
/// and wrenches three in the plane and six in space, forces two and three.
struct Claim {
  bool stable = false;                 ///< the claimed verdict
  std::optional<RationalRow> twist{};  ///< the claimed motion d, if it is given
  /// The claimed forces of the contacts on the object, one per contact, if they are given.
  std::optional<std::vector<RationalRow>> forces{};
};

/// The distances that count as near, and the limits of the work.
struct ClaimOptions {
  /// A verdict that a relative change of the load by this much would make right is a tie.
  Rational tie_distance = Rational(1, 1000000000);
  /// Residuals up to this fraction of the forces and motions at hand count as none
  /// (ResidualScale).
  Rational residual_tolerance = Rational(1, 1000000);
  /// The limit for each verdict and each margin; 0 is no limit in the plane, and in space that
  /// of SearchOptions.
  std::size_t node_limit = 0;
  /// Compute distances to the threshold for right claims as well.
  bool all_distances = false;
};

/// The largest of one kind of residual; `contact` is the first where it occurs, nothing if all
/// are 0.
struct LargestResidual {
  RootSum value;                     ///< its size, not negative
  std::optional<ContactId> contact;  ///< the contact where it is
};

/// The scale of residuals, which makes a tolerance a plain number whatever the units.
struct ResidualScale {
  /// The largest of the components of the load's force, of those of its torque over length, of
  /// the preloads, and of the components of the claimed contact forces; 1 if all are 0.
  Rational force = 1;
  Rational length = 1;  ///< the largest |coordinate| of a contact; 1 if all are 0
  /// The largest of the claimed translations, of the rotations times length, and of force/k
  /// with the largest stiffness k. The last keeps a motion that is nothing but noise from being
  /// its own scale.
  Rational motion = 1;
};

/// Returns the scale of the residuals of this claim about one grasp, as box_of() gives it.
/// O(m).
ResidualScale residual_scale(const GraspBox& grasp, const Claim& claim);

/// The conditions of an equilibrium that a claimed solution may miss.
enum class ResidualCondition { kBalance, kCone, kNormalLaw, kDissipation };

/// Returns "balance", "cone", "normal law" or "dissipation".
const char* name_of(ResidualCondition condition);

/// The amounts by which a claimed solution misses each condition. A contact has the unit normal
/// n and the force f; f_n = f.n, f_t = f - f_n n. A residual is absent if it needs a part of
/// the solution that is not given. All are exact: lengths of vectors in space, and of normals,
/// are roots.
struct ClaimResiduals {
  /// w + the wrenches of all forces: force, and torque. Needs forces.
  std::optional<RationalRow> balance;
  /// max(0, |f_t| - mu f_n, -f_n), a force. Needs forces.
  std::optional<LargestResidual> cone;
  /// |f_n - max(0, P - k n.u)|, bilateral |f_n - (P - k n.u)|, a force; u is how the claimed
  /// twist moves the point of contact. Needs forces and twist.
  std::optional<LargestResidual> normal_law;
  /// |mu f_n |s| + f_t.s|, with the slip s = u - (n.u) n: the power that friction falls short
  /// of the most that it could take out. Needs forces and twist.
  std::optional<LargestResidual> dissipation;

  /// Returns the conditions that are missed by more than `tolerance` times the scale: balance
  /// (a force by scale.force, a torque by force x length), cone and normal law (by force),
  /// dissipation (by force x motion). Exact.
  std::vector<ResidualCondition> missed(const Rational& tolerance,
                                        const ResidualScale& scale) const;
};

/// An exact equilibrium for a claim "stable".
struct NearbyEquilibrium {
  RationalRow twist;                ///< the motion d
  std::vector<RationalRow> forces;  ///< the forces of the contacts on the object, by ContactId
  bool from_claim = false;  ///< whether it has the modes that the claim suggests; else it is
                            ///< the engine's own
  /// \{ \brief Largest difference from the claim: of a component of a force in the object
  /// frame, and of a component of the twist.
  std::optional<Rational> force_distance;
  std::optional<Rational> twist_distance;
  /// \}
  /// Whether the same contacts slip, in the plane the same way; needs a claimed twist.
  std::optional<bool> same_slip;
  /// Whether the same contacts bear force.
  bool same_contacts = false;
};

/// The distance to a load with the other verdict: no load nearer than `low` has it; one at the
/// distance `high`, if there is one, does.
struct DistanceBounds {
  Rational low;                  ///< >= 0
  std::optional<Rational> high;  ///< >= low; equal if the distance is known exactly
};

/// The distance of the load w from one with the other verdict, as a relative change, in some
/// directions. F is the size of the load: the largest of the components of its force, and of
/// those of its torque over l; without load the largest preload, else 1. l is the largest
/// coordinate of a contact.
///
/// In the plane the distance is found exactly. In space it is enclosed; loads that no margin
/// along one direction sees are looked for in the box of all loads within a distance.
struct ThresholdDistance {
  /// The distance from w to l w: the smallest |l - 1| at an end of what is resisted. Nothing if
  /// the multiples of w are all resisted, or none.
  std::optional<DistanceBounds> along_load;
  /// The distance in the plane from w to w + s u for s >= 0 and u = +-(F, 0, 0), +-(0, F, 0),
  /// +-(0, 0, F l): the smallest s. (Without preload resistance does not change along w
  /// itself.)
  std::optional<DistanceBounds> along_axes;
  RationalRow axis;  ///< the u of along_axes, if there is one
  /// The distance in space from w to any load whose forces differ by at most s F, and whose
  /// torques by at most s F l. It is only compared with ClaimOptions::tie_distance: one of its
  /// ends is that.
  std::optional<DistanceBounds> all_at_once;
  /// The search that was given up, in words, if one was; the distances found hold all the same.
  std::optional<std::string> limit;

  /// Returns the smallest of these distances; nothing if no way leads to the other verdict.
  std::optional<DistanceBounds> smallest() const;
};

/// The class of a claim's verdict, held against the exact one.
enum class ClaimClass {
  kRight,      ///< the same verdict
  kTie,        ///< another verdict, but the threshold is within ClaimOptions::tie_distance
  kWrong,      ///< another verdict, and no excuse
  kUndecided,  ///< the exact verdict, or the distance of a disagreement, is beyond the limit
};

/// Returns "right", "tie", "wrong" or "undecided".
const char* name_of(ClaimClass claim_class);

/// The judgement of a claim.
struct ClaimReport {
  ClaimClass claim_class = ClaimClass::kUndecided;  ///< the class of the claimed verdict
  Answer answer;                                    ///< the exact verdict, with its evidence
  ClaimResiduals residuals;                         ///< the residuals of the claimed solution
  ResidualScale scale;                              ///< the scale of the residuals
  /// True for a right claim "stable" whose solution has residuals beyond the tolerance.
  bool inaccurate = false;
  /// The slips of the claimed twist by contact: in the plane the signs of T_i.d. A slip in
  /// space has no sign, and is kPositive unless it is 0.
  std::optional<std::vector<Sign>> claimed_slip{};
  /// An equilibrium for a claim "stable" with a solution, if the exact verdict is stable.
  std::optional<NearbyEquilibrium> nearby{};
  /// The reason why there is no `nearby` then: the verdict is proved without an exact
  /// equilibrium.
  std::optional<std::string> no_nearby{};
  /// The distance of a disagreement, or of any claim if the options say so.
  std::optional<ThresholdDistance> distance{};
};

/// Judges the claim by the three questions above. Throws InputError if the question is about
/// uncertain numbers; if, in the plane, a preloaded contact has a normal of irrational length
/// (problem_of); and if the claim does not have one force per contact. Requires vectors of as
/// many coordinates as the grasp has.
ClaimReport judge_claim(const Question& question, const Claim& claim,
                        const ClaimOptions& options = {});

/// Returns the residuals that judge_claim reports, of one grasp as box_of() gives it. O(m).
ClaimResiduals residuals_of(const GraspBox& grasp, NormalLaw law, const Claim& claim);

/// \{ Return the distance that judge_claim reports, of one grasp: in the plane by seven load
/// margins; in space, where `stable` is the verdict, by a margin and the verdict about all
/// loads within the tie distance.
ThresholdDistance threshold_distance(const Problem& problem, const Grasp& grasp,
                                     std::size_t node_limit = 0);
ThresholdDistance threshold_distance(const Question& question, bool stable,
                                     const ClaimOptions& options);
/// \}

/// One line of a claims file (docs/crosscheck.md): JSON Lines, a question and a claim each. All
/// numbers are exact, as in grasp files.
struct ClaimLine {
  Question question;  ///< about the grasp of the line, or of the file that it names
  Claim claim;        ///< the answer to it
};

/// Reads one line. `folder` is where the names of grasp files start; empty is the current one.
/// Throws InputError with a line:column (the line being 1) or a JSON path such as
/// "claim.twist[1]", or naming the grasp file that the line refers to.
ClaimLine parse_claim_line(std::string_view line, const std::string& folder);

}  // namespace stickslip
