// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Another program's answer held against the exact one.
///
/// A *claim* says of a question (equilibrium/question.hpp) "stable" or "unstable", and may add
/// the motion and the forces that were found. It is judged exactly, by three questions:
///
/// - Is the verdict right? If not, how far is the load from one for which it would be: is this
///   a wrong answer, or a *tie* that no double-precision program can be expected to see?
/// - By how much does the claimed solution miss each condition of problem.hpp?
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

#include "stickslip/core/sign.hpp"
#include "stickslip/equilibrium/question.hpp"
#include "stickslip/margin/margin.hpp"
#include "stickslip/planar/decide.hpp"
#include "stickslip/planar/nearby.hpp"

namespace stickslip {

/// What another program says of a question.
struct Claim {
  bool stable = false;  ///< the claimed verdict
  /// The claimed motion and forces, as far as they are given. Forces are coefficients (a, b) of
  /// the contact's own normal and tangent, like those of a Witness: of a force vector f of
  /// any contact a = f.n/|n|^2, b = f.t/|n|^2; of magnitudes a = c_n/|n|, b = c_t/|n|.
  ApproximateEquilibrium solution;
};

/// What counts as near, and how much work to spend.
struct ClaimOptions {
  /// A verdict that a relative change of the load by this much would make right is a tie.
  Rational tie_distance = Rational(1, 1000000000);
  /// Residuals up to this fraction of the forces and motions at hand count as none
  /// (ResidualScale).
  Rational residual_tolerance = Rational(1, 1000000);
  /// For each verdict and each margin; 0 is no limit.
  std::size_t node_limit = 0;
  /// Compute distances to the threshold for right claims as well.
  bool all_distances = false;
};

/// coefficient * sqrt(radicand) >= 0: the length of a multiple of a contact's normal, which is
/// irrational where the normal's own length is. radicand is 1 where it is rational.
struct Magnitude {
  Rational coefficient;   ///< not negative
  Rational radicand = 1;  ///< positive

  /// |coefficient| * sqrt(length_squared), for length_squared > 0.
  static Magnitude of(const Rational& coefficient, const Rational& length_squared);
  /// Exact, by the squares.
  bool operator<(const Magnitude& other) const;
};

/// The largest of one kind of residual; `contact` is the first where it occurs, nothing if all
/// are 0.
struct LargestResidual {
  Magnitude value;                   ///< how large it is
  std::optional<ContactId> contact;  ///< where it is
};

/// What residuals are held against, so that a tolerance is a plain number whatever the units.
struct ResidualScale {
  /// The largest of |w_x|, |w_y|, |torque|/length, of the preloads, and of the components of
  /// the claimed contact forces in the object frame; 1 if all are 0.
  Rational force = 1;
  Rational length = 1;  ///< largest_coordinate
  /// The largest of |d_x|, |d_y|, |d_r| length of the claimed twist, and of force/k with the
  /// largest stiffness k: a motion that is nothing but noise is not held against itself.
  Rational motion = 1;
};

/// The scale of the residuals of this solution. O(m).
ResidualScale residual_scale(const LoadedGrasp& loaded, const ApproximateEquilibrium& claimed);

/// The largest |coordinate| of a contact, 1 if all are 0: torque divided by it is like a force.
Rational largest_coordinate(const Grasp& grasp);

/// The conditions of an equilibrium that a claimed solution may miss.
enum class ResidualCondition { kBalance, kCone, kNormalLaw, kDissipation };

/// "balance", "cone", "normal law", "dissipation"
const char* name_of(ResidualCondition condition);

/// By how much a claimed solution misses each condition. What needs a part of the solution that
/// is not given is absent.
struct ClaimResiduals {
  /// w + sum (a N + b T): force x, force y, torque. Needs forces.
  std::optional<Wrench> balance;
  /// max(0, |b| - mu a, -a), as a force. Needs forces.
  std::optional<LargestResidual> cone;
  /// |a - max(0, v)|, bilateral |a - v|, as a force. Needs forces and twist.
  std::optional<LargestResidual> normal_law;
  /// |mu a |tau| + b tau|, tau = T.d: what friction falls short of the most it could take out,
  /// as a power. Needs forces and twist.
  std::optional<LargestResidual> dissipation;

  /// The conditions that are missed by more than `tolerance` times the scale: of balance (a
  /// force by scale.force, the torque by force x length), cone and normal law (by force),
  /// dissipation (by force x motion).
  std::vector<ResidualCondition> missed(const Rational& tolerance,
                                        const ResidualScale& scale) const;
};

/// An exact equilibrium for a claim "stable".
struct NearbyEquilibrium {
  Witness witness;          ///< passes find_violation
  bool from_claim = false;  ///< by find_witness_like; else it is the engine's own
  /// \{ \brief Largest difference from the claim: of a component of a force in the object
  /// frame, and of a component of the twist.
  std::optional<Rational> force_distance;
  std::optional<Rational> twist_distance;
  /// \}
  /// Whether all T_i.d have the signs they have in the claim; needs a claimed twist.
  std::optional<bool> same_slip;
  /// Whether the same contacts bear force, a > 0.
  bool same_contacts = false;
};

/// The smallest relative change of the load w that changes the verdict, in some directions.
struct ThresholdDistance {
  /// Of w to l w: the smallest |l - 1| over the ends l of what is resisted. Nothing if the
  /// multiples of w are all resisted, or none.
  std::optional<Rational> along_load;
  /// Of w to w + s u for s >= 0 and u = +-(F, 0, 0), +-(0, F, 0), +-(0, 0, F l): the smallest
  /// s, and u. F is the size of the load, max(|w_x|, |w_y|, |torque|/l), without load the
  /// largest preload, else 1; l is largest_coordinate.
  /// (Without preload resistance does not change along w itself.)
  std::optional<Rational> along_axes;
  Wrench axis;  ///< the u of along_axes, if there is one
  /// Set if a margin was given up at the node limit; the above are then those that were found.
  std::optional<std::string> limit;

  /// The smaller of the two that were found; nothing if none was.
  std::optional<Rational> smallest() const;
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
  Decision decision;                                ///< the exact verdict, with its evidence
  ClaimResiduals residuals;                         ///< of the claimed solution
  ResidualScale scale;                              ///< what they are held against
  /// Of a right claim "stable" whose solution is not one: residuals beyond the tolerance.
  bool inaccurate = false;
  std::optional<std::vector<Sign>> claimed_slip;  ///< the signs of T_i.d of the claimed twist
  /// For a claim "stable" with a solution, if the exact verdict is stable.
  std::optional<NearbyEquilibrium> nearby;
  /// Of disagreements, and of all if the options say so.
  std::optional<ThresholdDistance> distance;
};

/// Judges the claim by the three questions above. Throws InputError when a preloaded contact
/// has a normal of irrational length (Problem), and when the claim does not have one force per
/// contact.
ClaimReport judge_claim(const Question& question, const Claim& claim,
                        const ClaimOptions& options = {});

/// What judge_claim reports as residuals. O(m).
ClaimResiduals residuals_of(const Problem& problem, const ApproximateEquilibrium& claimed);

/// What judge_claim reports as distance: seven load margins.
ThresholdDistance threshold_distance(const Problem& problem, const Grasp& grasp,
                                     const ConeOptions& options = {});

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
