// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Another program's answer held against the exact one.
///
/// A *claim* says of a question (engine/question.hpp) "stable" or "unstable", and may add
/// the motion and the forces that were found. It is judged exactly, by three questions:
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
#include "stickslip/engine/question.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {

/// What another program says of a question. Vectors have the coordinates of the grasp: twists
/// and wrenches three in the plane and six in space, forces two and three.
struct Claim {
  bool stable = false;                 ///< the claimed verdict
  std::optional<RationalRow> twist{};  ///< the claimed motion d, if it is given
  /// The claimed forces of the contacts on the object, one per contact, if they are given.
  std::optional<std::vector<RationalRow>> forces{};
};

/// What counts as near, and how much work to spend.
struct ClaimOptions {
  /// A verdict that a relative change of the load by this much would make right is a tie.
  Rational tie_distance = Rational(1, 1000000000);
  /// Residuals up to this fraction of the forces and motions at hand count as none
  /// (ResidualScale).
  Rational residual_tolerance = Rational(1, 1000000);
  /// For each verdict and each margin; 0 is no limit in the plane, and in space that of
  /// SearchOptions.
  std::size_t node_limit = 0;
  /// Compute distances to the threshold for right claims as well.
  bool all_distances = false;
};

/// The largest of one kind of residual; `contact` is the first where it occurs, nothing if all
/// are 0.
struct LargestResidual {
  RootSum value;                     ///< how large it is, not negative
  std::optional<ContactId> contact;  ///< where it is
};

/// What residuals are held against, so that a tolerance is a plain number whatever the units.
struct ResidualScale {
  /// The largest of the components of the load's force, of those of its torque over length, of
  /// the preloads, and of the components of the claimed contact forces; 1 if all are 0.
  Rational force = 1;
  Rational length = 1;  ///< the largest |coordinate| of a contact; 1 if all are 0
  /// The largest of the claimed translations, of the rotations times length, and of force/k
  /// with the largest stiffness k: a motion that is nothing but noise is not held against
  /// itself.
  Rational motion = 1;
};

/// The scale of the residuals of this claim about one grasp, as box_of() gives it. O(m).
ResidualScale residual_scale(const GraspBox& grasp, const Claim& claim);

/// The conditions of an equilibrium that a claimed solution may miss.
enum class ResidualCondition { kBalance, kCone, kNormalLaw, kDissipation };

/// "balance", "cone", "normal law", "dissipation"
const char* name_of(ResidualCondition condition);

/// By how much a claimed solution misses each condition: of a contact with unit normal n and
/// force f, f_n = f.n, f_t = f - f_n n. What needs a part of the solution that is not given is
/// absent. All are exact: lengths of vectors in space, and of normals, are roots.
struct ClaimResiduals {
  /// w + the wrenches of all forces: force, and torque. Needs forces.
  std::optional<RationalRow> balance;
  /// max(0, |f_t| - mu f_n, -f_n), a force. Needs forces.
  std::optional<LargestResidual> cone;
  /// |f_n - max(0, P - k n.u)|, bilateral |f_n - (P - k n.u)|, a force; u is how the claimed
  /// twist moves the point of contact. Needs forces and twist.
  std::optional<LargestResidual> normal_law;
  /// |mu f_n |s| + f_t.s|, with the slip s = u - (n.u) n: what friction falls short of the most
  /// it could take out, as a power. Needs forces and twist.
  std::optional<LargestResidual> dissipation;

  /// The conditions that are missed by more than `tolerance` times the scale: of balance (a
  /// force by scale.force, a torque by force x length), cone and normal law (by force),
  /// dissipation (by force x motion). Exact.
  std::vector<ResidualCondition> missed(const Rational& tolerance,
                                        const ResidualScale& scale) const;
};

/// An exact equilibrium for a claim "stable".
struct NearbyEquilibrium {
  RationalRow twist;                ///< the motion d
  std::vector<RationalRow> forces;  ///< of the contacts on the object, by ContactId
  bool from_claim = false;  ///< with the modes that the claim suggests; else the engine's own
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

/// How far it is to a load with the other verdict: no nearer one has it, and, if there is a
/// `high`, one so far away does.
struct DistanceBounds {
  Rational low;                  ///< >= 0
  std::optional<Rational> high;  ///< >= low; equal where the distance is known exactly
};

/// How far the load w is from one with the other verdict, as a relative change, in some
/// directions. F is the size of the load: the largest of the components of its force, and of
/// those of its torque over l; without load the largest preload, else 1; l is the largest
/// coordinate of a contact.
///
/// In the plane it is found exactly. In space it is enclosed; and what no margin along one
/// direction sees is looked for in the box of all loads within a distance.
struct ThresholdDistance {
  /// Of w to l w: the smallest |l - 1| at an end of what is resisted. Nothing if the multiples
  /// of w are all resisted, or none.
  std::optional<DistanceBounds> along_load;
  /// In the plane: of w to w + s u for s >= 0 and u = +-(F, 0, 0), +-(0, F, 0), +-(0, 0, F l):
  /// the smallest s, and u.
  /// (Without preload resistance does not change along w itself.)
  std::optional<DistanceBounds> along_axes;
  RationalRow axis;  ///< the u of along_axes, if there is one
  /// In space: of w to any load whose forces differ by at most s F, and whose torques by at
  /// most s F l. Only held against ClaimOptions::tie_distance: one of its ends is that.
  std::optional<DistanceBounds> all_at_once;
  /// Set if something was given up, in words; what was found holds all the same.
  std::optional<std::string> limit;

  /// Of any of these ways; nothing if no way leads to the other verdict.
  std::optional<DistanceBounds> smallest() const;
};

/// What a claim's verdict is, held against the exact one.
enum class ClaimClass {
  kRight,      ///< the same verdict
  kTie,        ///< another verdict, but the threshold is within ClaimOptions::tie_distance
  kWrong,      ///< another verdict, and no excuse
  kUndecided,  ///< the exact verdict, or the distance of a disagreement, is beyond the limit
};

/// "right", "tie", "wrong", "undecided"
const char* name_of(ClaimClass claim_class);

/// The judgement of a claim.
struct ClaimReport {
  ClaimClass claim_class = ClaimClass::kUndecided;  ///< of the claimed verdict
  Answer answer;                                    ///< the exact verdict, with its evidence
  ClaimResiduals residuals;                         ///< of the claimed solution
  ResidualScale scale;                              ///< what they are held against
  /// Of a right claim "stable" whose solution is not one: residuals beyond the tolerance.
  bool inaccurate = false;
  /// Of the claimed twist by contact: in the plane the signs of T_i.d. A slip in space has no
  /// sign, and is kPositive unless it is 0.
  std::optional<std::vector<Sign>> claimed_slip{};
  /// For a claim "stable" with a solution, if the exact verdict is stable.
  std::optional<NearbyEquilibrium> nearby{};
  /// Why there is no `nearby` then: the verdict is proved without an exact equilibrium.
  std::optional<std::string> no_nearby{};
  /// Of disagreements, and of all if the options say so.
  std::optional<ThresholdDistance> distance{};
};

/// Judges the claim by the three questions above. Throws InputError when the question is about
/// uncertain numbers or, in the plane, a preloaded contact has a normal of irrational length
/// (problem_of), and when the claim does not have one force per contact. Requires vectors of as
/// many coordinates as the grasp has.
ClaimReport judge_claim(const Question& question, const Claim& claim,
                        const ClaimOptions& options = {});

/// What judge_claim reports as residuals, of one grasp as box_of() gives it. O(m).
ClaimResiduals residuals_of(const GraspBox& grasp, NormalLaw law, const Claim& claim);

/// \{ What judge_claim reports as distance, of one grasp: in the plane seven load margins; in
/// space, where the verdict is `stable`, a margin and the verdict about all loads within the
/// tie distance.
ThresholdDistance threshold_distance(const Problem& problem, const Grasp& grasp,
                                     std::size_t node_limit = 0);
ThresholdDistance threshold_distance(const Question& question, bool stable,
                                     const ClaimOptions& options);
/// \}

/// What one line of a claims file says (docs/crosscheck.md): JSON Lines, a question and a claim
/// each. All numbers are exact, as in grasp files.
struct ClaimLine {
  Question question;  ///< about the grasp of the line, or of the file that it names
  Claim claim;        ///< the answer to it
};

/// One line. `folder` is where the names of grasp files start; empty is the current one. Throws
/// InputError with a line:column (the line being 1) or a JSON path such as "claim.twist[1]", or
/// naming the grasp file that the line refers to.
ClaimLine parse_claim_line(std::string_view line, const std::string& folder);

}  // namespace stickslip
