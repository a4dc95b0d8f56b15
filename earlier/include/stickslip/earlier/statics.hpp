// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Statics of any number of bodies: do any forces at the contacts balance the load, whatever
/// stiffness and preloads would make of it?
///
/// - They *must move* if a motion y exists on which the load does positive work, and no force
///   that the contacts can exert does negative work. Then no forces balance the load.
/// - They *may stand* if some forces in Coulomb's cones balance the load: it is weakly stable
///   (load_classes.hpp).
///
/// A contact exerts a N + S^T f with a >= 0 and |f| <= mu L a (letters as in law.hpp), in the
/// plane, in space, or with torsion. A ratchet exerts a N with a >= 0. A spring with stiffness
/// exerts any force, as a joint that is locked; one without stiffness exerts its torque or
/// tension.
///
/// A contact with a limit (UncertainContact::max_force) has a L of at most that, and a joint
/// with a motor (Spring::max_torque) exerts any torque up to its limit. Then a motion comes with
/// a number q >= 0 for each limit, which follow those of the motion: no force of the contact
/// does work of less than -q for each unit of a, and the load does more than the sum of the
/// limits of a times q.
///
/// **Method.** Doubles propose forces deep in all cones, or a motion that opens all contacts
/// that can open (cone_program.hpp). A motion is rounded, and then judged exactly. Forces are
/// rounded, too; they leave a small part of the load unbalanced, which is passed exactly from
/// body to body along a tree of contacts to the ground. Both take time and memory linear in the
/// number of contacts, but for the length of numbers. In the plane, with up to 60 coordinates
/// of motions (twenty bodies), an exact linear program decides where doubles do not.
///
/// Sources: Livesley, "Limit analysis of structures formed from rigid blocks", Int. J. Numer.
/// Methods Eng. 12, 1978; Whiting, Ochsendorf, Durand, "Procedural modeling of
/// structurally-sound masonry buildings", ACM Trans. Graph. 28(5), 2009.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/earlier/load_classes.hpp"

namespace stickslip {

/// Decides whether the bodies of one grasp may stand, with all friction multiplied by a factor
/// >= 0. The forces are those of contacts and then of springs; RigidForce::normal of a spring
/// is its force, of either sign, and is left 0 for a spring without stiffness. The evidence has
/// been checked by substitution. Throws ContractError if a number is uncertain.
LoadClass statics(const GraspBox& grasp, const Rational& friction_factor = 1);

/// Returns "may stand", "must move" or "undecided".
std::string name_of(const LoadClass& found);

/// Bounds of the least factor by which all friction may be multiplied so that the bodies may
/// stand: it is in [low, high].
struct LeastFriction {
  Rational low{0};           ///< they must move with this factor, unless `motion` is empty
  UnopposedMotion motion{};  ///< the evidence for `low`; empty if there is none, and low is 0
  Rational high{0};          ///< they may stand with this factor
  RigidForces forces{};      ///< the evidence for `high`
};

/// Encloses the least factor of friction. The difference high - low is at most `accuracy` times
/// high, or times `accuracy` if that is larger, unless factors between the two stay undecided.
/// Returns the motion instead if they must move with any friction, or with friction times a
/// million; Undecided if neither that nor a factor with which they may stand is found.
std::variant<LeastFriction, UnopposedMotion, Undecided> least_friction(
    const GraspBox& grasp, const Rational& accuracy = Rational(1, 1000000));

/// Evidence about a line or plane of loads: forces that balance the load h w + sum l_k u_k. The
/// load at l may stand if h = 1. A point with h = 0 is a direction l in which the loads that
/// may stand have no end: these forces may be added to those of any other load.
struct StandPoint {
  RationalRow point;   ///< h >= 0, and l_k for each direction u_k
  RigidForces forces;  ///< the forces of contacts and then of springs
};

/// The loads w + sum l_k u_k of one or two directions u_k: which may stand, and which must
/// move.
struct StandingLoads {
  /// The load at l may stand if (1, l) is a sum of multiples >= 0 of these points: the convex
  /// hull of those with h = 1, and all that lies from it in the directions of those with h = 0.
  std::vector<StandPoint> stand{};
  /// Motions, coprime integers, that no contact opposes. The load at l must move if it does
  /// positive work on one of these.
  std::vector<RationalRow> move{};
  bool is_exact = true;  ///< whether each load is in one of the two sets
  /// Whether the loads in neither set are all as near to the border as the accuracy asks for.
  bool is_complete = true;
};

/// Returns the loads of one direction or two that may stand: exactly in the plane, if there are
/// at most 60 coordinates of motions (twenty bodies). Else some loads stay undecided near the
/// border: along rays from a load that may stand, at most a part `accuracy` of the distance to
/// the border. Throws InputError at "direction" if the one direction is 0, and at "plane" if
/// the two are linearly dependent; ContractError if there are not one or two.
StandingLoads standing_loads(const GraspBox& grasp, const std::vector<RationalRow>& directions,
                             const Rational& friction_factor = 1,
                             const Rational& accuracy = Rational(1, 1000));

/// The multiples l of one direction: those in [low, high] may stand, those below `below` and
/// those above `above` must move, and between these nothing is known.
struct StandingMultiples {
  bool any = false;                 ///< whether some multiple is known that may stand
  std::optional<Rational> low{};    ///< the least that may stand; nothing: no end, if `any`
  std::optional<Rational> high{};   ///< the greatest that may stand; nothing: no end, if `any`
  std::optional<Rational> below{};  ///< multiples below it must move; nothing: none is known
  std::optional<Rational> above{};  ///< multiples above it must move; nothing: none is known
  bool always_moves = false;        ///< whether all must move
};
/// Returns the multiples of one direction, from what standing_loads() returned for it.
StandingMultiples multiples_of(const GraspBox& grasp, const StandingLoads& loads,
                               const RationalRow& direction);

}  // namespace stickslip
