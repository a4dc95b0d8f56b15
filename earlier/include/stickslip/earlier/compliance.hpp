// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Grasp compliance: springs along the normals *and* the tangents, whose forces are checked
/// against the friction cones afterwards.
///
/// The object moves by d. A spring contact has (unit normals; else as in contact_row.hpp)
///
///     c_n = P - k N.d,    c_t = -k T.d,
///
/// with the tangential stiffness equal to the normal one; Cutkosky and Kao let them differ, a
/// grasp file has one. Tangential springs start unstretched, so preloads that balance only with
/// friction move the object. Balance is the linear system K d = w + sum P_i N_i with
/// K = sum k_i (N_i N_i^T + T_i T_i^T) over the springs. If K y = 0 then y stretches no spring,
/// so the forces are unique even where d is not.
///
/// **Linear** (Cutkosky and Kao; Bicchi): every contact has both springs. It holds iff balance
/// is possible and every force is in its friction cone.
///
/// **Three states** (Prattichizzo, Salisbury and Bicchi): each contact
///
/// - sticks: both springs, |c_t| <= mu c_n;
/// - slips: its normal spring, c_n >= 0, and no friction, c_t = 0;
/// - is detached: no force, and its spring is released, P - k N.d <= 0.
///
/// It holds iff one of the 3^m combinations has a solution. A detached contact must have been
/// released: without this condition contact 1 of Fig. 1 could let go while it is compressed,
/// and the load (0, 1, 0) with P = 1, which the paper says this method rejects, would be held
/// by the other two.
///
/// Neither model depends on the normal law.
///
/// Source: Cutkosky and Kao, "Computing and controlling the compliance of a robotic hand", IEEE
/// Trans. Robotics and Automation 5(2), 1989; Bicchi, "Force distribution in multiple
/// whole-limb manipulation", ICRA 1993; Prattichizzo, Salisbury and Bicchi, "Contact and grasp
/// robustness measures", Experimental Robotics IV, 1997; Haas-Heger et al., RSS 2018, Sections
/// III and VI.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// Springs in balance with the load.
struct SpringBalance {
  Witness springs;  ///< the motion, and the forces of both springs of each contact
  /// A contact whose force is outside its friction cone: the one for which |c_t| - mu c_n, or
  /// -c_n without friction, is largest. The method holds iff there is none.
  std::optional<ContactId> outside;
};

/// A motion that no spring resists, N_i.d = T_i.d = 0 for all i, and along which the load does
/// work.
struct UnresistedMotion {
  Row motion;  ///< coprime integers
};

/// Solves one linear system of size 3; its solution is checked by substitution.
std::variant<SpringBalance, UnresistedMotion> linear_compliance(const Problem& problem);

/// Springs in balance with the load in space. All three springs of a contact are equally stiff,
/// so its force is P n / |n| - k u, with u the displacement of its point.
struct SpatialSpringBalance {
  RationalRow motion;           ///< d
  std::vector<Vector3> forces;  ///< by ContactId
  /// A contact whose force is outside its friction cone: one that pulls, or the one whose
  /// friction is the largest multiple of the most that there may be.
  std::optional<ContactId> outside;
};

/// Solves the same in space, for a grasp without uncertain numbers: one linear system of size
/// 6. Throws InputError ("contacts[i].normal") at a preloaded contact with a normal of
/// irrational length.
std::variant<SpatialSpringBalance, UnresistedMotion> linear_compliance(const GraspBox& grasp);

/// The state of a contact in the three-state model.
enum class SpringState { kStick, kSlip, kDetached };

/// A combination of states that balances the load.
struct SpringStates {
  std::vector<SpringState> states;  ///< by ContactId
  Witness springs;                  ///< the motion, and the forces in these states
};

/// Evidence that no combination balances the load: each was refuted by Farkas multipliers that
/// were verified.
struct NoSpringStates {
  std::size_t combinations = 0;  ///< 3^m
};

/// Tries combinations with sticking first, and earlier contacts varying slowest: 3^m linear
/// programs in 3 variables. Undecided without a try above `most_contacts` contacts. The
/// solution is checked by substitution.
std::variant<SpringStates, NoSpringStates, Undecided> three_state_compliance(
    const Problem& problem, std::size_t most_contacts = 10);

}  // namespace stickslip
