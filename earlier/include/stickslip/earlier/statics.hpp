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

#include <variant>

#include "stickslip/core/box.hpp"
#include "stickslip/earlier/load_classes.hpp"

namespace stickslip {

/// Decides whether the bodies of one grasp may stand, with all friction multiplied by a factor
/// >= 0. Forces are by element: of a spring the normal is its force, of either sign. Requires
/// that no number is uncertain. Evidence is checked by substitution.
LoadClass statics(const GraspBox& grasp, const Rational& friction_factor = 1);

/// The least factor of all friction with which bodies may stand is in [low, high].
struct LeastFriction {
  Rational low{0};           ///< they must move with this factor, unless it is 0
  UnopposedMotion motion{};  ///< the evidence for `low`; empty if it is 0 and they may stand
  Rational high{0};          ///< they may stand with this factor
  RigidForces forces{};      ///< the evidence for `high`
};

/// Encloses the least factor of friction: high - low is at most `accuracy` times high, unless
/// programs between them stay undecided. Returns the motion if they must move with any
/// friction, and Undecided if no factor up to a million is found with which they may stand.
std::variant<LeastFriction, UnopposedMotion, Undecided> least_friction(
    const GraspBox& grasp, const Rational& accuracy = Rational(1, 1000000));

}  // namespace stickslip
