// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Statics of any number of bodies: may they stand at all, with any stiffness and preloads?
///
/// - They *must move* if a motion y exists on which the load does positive work, and no force
///   that the contacts can exert does negative work. Then no forces balance the load.
/// - They *may stand* if some forces in Coulomb's cones balance the load: it is weakly stable
///   (load_classes.hpp).
///
/// A contact presses and rubs, a N + S^T f with |f| <= mu L a, in the plane, in space, or with
/// torsion; a ratchet presses. A spring with stiffness holds with any force, as a joint that is
/// locked; one without exerts its torque or tension.
///
/// **Method.** Doubles propose forces deep in all cones, or a motion that opens all contacts
/// that it may (cone_program.hpp). A motion is rounded and judged. What rounded forces leave of
/// the load is pushed from body to body along a tree of contacts to the ground, exactly. Both
/// take time and memory linear in the number of contacts, but for the length of numbers. In the
/// plane an exact linear program decides where doubles do not.
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
/// >= 0. Forces are by element: of a spring the normal is its force, of either sign. Requires
/// that no number is uncertain. Evidence is checked by substitution.
LoadClass statics(const GraspBox& grasp, const Rational& friction_factor = 1);

/// Returns "may stand", "must move" or "undecided".
std::string name_of(const LoadClass& found);

/// The least factor of all friction with which bodies may stand is in [low, high].
struct LeastFriction {
  Rational low{0};           ///< they must move with this factor, unless it is 0
  UnopposedMotion motion{};  ///< the evidence for `low`; empty if it is 0 and they may stand
  Rational high{0};          ///< they may stand with this factor
  RigidForces forces{};      ///< the evidence for `high`
};

/// Encloses the least factor of friction: high - low is at most `accuracy` times high, unless
/// programs between them stay undecided. Returns the motion if they must move with any
/// friction, or with all of it times a million, and Undecided if that is not known.
std::variant<LeastFriction, UnopposedMotion, Undecided> least_friction(
    const GraspBox& grasp, const Rational& accuracy = Rational(1, 1000000));

/// Forces that balance the load h w + sum l_k u_k of a plane or line of loads. If h is 0, so do
/// they together with any others.
struct StandPoint {
  RationalRow point;   ///< h >= 0, and l_k for each direction
  RigidForces forces;  ///< forces by element
};

/// The loads w + sum l_k u_k of one or two directions: which may stand, and which must move.
struct StandingLoads {
  /// The l for which (1, l) is a sum of multiples >= 0 of these points may stand.
  std::vector<StandPoint> stand{};
  /// The l for which the load does positive work on one of these must move. They are integers.
  std::vector<RationalRow> move{};
  bool is_exact = true;     ///< whether no load is left between the two, but their border
  bool is_complete = true;  ///< whether what is left is no more than was asked for
};

/// Returns the loads of one direction or two that may stand; in the plane exactly, if there are
/// not too many bodies. Else what is left undecided is, along rays from a load that may stand,
/// at most a part `accuracy` of the distance to the border. Throws InputError ("plane") if two
/// directions are linearly dependent, and ("direction") if one is 0.
StandingLoads standing_loads(const GraspBox& grasp, const std::vector<RationalRow>& directions,
                             const Rational& friction_factor = 1,
                             const Rational& accuracy = Rational(1, 1000));

/// The multiples l of one direction: [low, high] may stand, where an end that is missing is
/// none, and below and above borders they must move.
struct StandingMultiples {
  bool any = false;                 ///< whether some may stand
  std::optional<Rational> low{};    ///< the least that may stand
  std::optional<Rational> high{};   ///< the greatest
  std::optional<Rational> below{};  ///< those below it must move
  std::optional<Rational> above{};  ///< those above it must move
  bool always_moves = false;        ///< whether all must move
};
/// Returns what loads of one direction say of its multiples.
StandingMultiples multiples_of(const GraspBox& grasp, const StandingLoads& loads,
                               const RationalRow& direction);

}  // namespace stickslip
