// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs of verdicts that state no equilibrium: trees that refute regions, and bodies of
/// motions that hold an equilibrium (certificate/FORMAT.md, sections 4 to 7). Motions may have
/// any number of coordinates.
#pragma once

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/core/ids.hpp"
#include "stickslip/core/row.hpp"
#include "stickslip/engine/part.hpp"

namespace stickslip {

/// A split by the slip of a contact. If slips have one dimension there are three children: slip
/// +, 0 and -. Else there are two: s = 0, and s strict.
struct SlipSplit {
  ContactId contact;  ///< the contact
};
/// A split by the separation v_i of a contact. It has two children: closed, open.
struct SeparationSplit {
  ContactId contact;  ///< the contact
};
/// A split by what one contact does.
using ContactSplit = std::variant<SlipSplit, SeparationSplit>;
/// A cut by a plane. It has two children, plane.x >= 0 and plane.x <= 0, for points x = (d, h,
/// l).
struct PlaneCut {
  Row plane;  ///< nonzero
};
/// A leaf with a virtual twist on which no force of the region makes up for the load. The twist
/// is 0 where the region is void: no solution can lie there, or another child covers it.
struct TwistLeaf {
  Row twist;  ///< y
};

/// A leaf with a virtual twist y(x) = rate d + h twist that moves with the point (d, h, l).
/// What friction does for certain, it works against a contact's own slip, limits the work of
/// the part that follows the motion (certificate/FORMAT.md, section 4, "Leaf whose twist
/// moves").
struct MovingLeaf {
  /// The part of a contact's friction that is known to work against its own slip.
  struct OwnSlip {
    ContactId contact;  ///< the contact
    Integer rate;       ///< kappa >= 0, the part of y that follows the slip
    Row slip;           ///< psi, |psi| <= kappa, with as many numbers as a slip
  };
  Row twist;                 ///< y
  Integer rate;              ///< c
  std::vector<OwnSlip> own;  ///< by increasing contact; of all others kappa and psi are 0
};

/// A node: one of four kinds of split, or a leaf.
using TreeNode =
    std::variant<SlipSplit, SeparationSplit, PlaneCut, TwistLeaf, MovingLeaf, PartSplit>;
/// Trees in preorder, one after another.
using Trees = std::vector<TreeNode>;

/// Returns how many nodes are leaves.
std::size_t leaf_count(const Trees& trees);

/// A body of motions: the parallelepiped {d : |E_j.(d - d0)| <= 1} or the simplex {d : E_j.(d -
/// d0) <= 1}. It goes on without end along motions that no E sees.
struct ConvexBody {
  RationalRow twist{};               ///< d0, a motion inside
  bool is_simplex = false;           ///< whether it is a simplex, with one more E
  std::vector<RationalRow> walls{};  ///< E, by rows

  /// Returns the number of walls. Those of a parallelepiped are in the order E_1 +, E_1 -, E_2
  /// +, ...
  std::size_t wall_count() const { return is_simplex ? walls.size() : 2 * walls.size(); }
};

/// A proof by degree: every grasp of a part of a box has an equilibrium in a body of motions.
struct DegreeProof : ConvexBody {
  std::vector<RationalRow> direction{};  ///< A, by rows
  Trees trees{};  ///< list 1 unless it is not needed, and list 2; a tree for each wall
  /// Contacts that are open on all of the body across the motions that no E sees, increasing:
  /// all else is about the grasps without them.
  std::vector<ContactId> open{};
};

/// Returns whether the walls and the direction of a proof both have this rank, which is that of
/// all forces (certificate/FORMAT.md, `degree-walls` and `degree-direction`).
bool has_rank(const DegreeProof& proof, std::size_t rank);

/// A proof at rest: nothing moves. Each grasp of a box is balanced by friction f0 + sum of G_l
/// z_l for some z with |z_l| <= reach_l. A friction force has as many coordinates as a slip.
struct RestProof {
  /// The answer G of a contact: the friction with which it answers a unit of each component of
  /// a wrench.
  struct Answer {
    ContactId contact;                ///< the contact whose friction it is
    std::vector<RationalRow> forces;  ///< friction across its normal, for each component
  };
  std::vector<std::pair<ContactId, RationalRow>> friction;  ///< f0 by contact, increasing
  std::vector<Answer> answers;                              ///< G, by increasing contact
  RationalRow reach;                                        ///< reach >= 0, for each component
};

/// A proof by sticking: every grasp of the box has an equilibrium near a motion d0 at which
/// contacts stick. The friction f0, with answers of friction and of normal forces, balances
/// each grasp, and friction has more to spare than the remaining errors take away
/// (certificate/FORMAT.md, section 6, "Stable: sticking").
struct StickingProof {
  /// The answer H of a contact: how much more it presses for a unit of each component of a
  /// wrench.
  struct Press {
    ContactId contact;   ///< the contact that presses
    RationalRow forces;  ///< the increase of its force, for each component
  };
  RationalRow motion;                                       ///< d0
  std::vector<std::pair<ContactId, RationalRow>> friction;  ///< f0 by contact, increasing
  std::vector<Press> presses;                               ///< H, by increasing contact
  std::vector<RestProof::Answer> answers;                   ///< G, by increasing contact
  RationalRow reach;                                        ///< reach > 0, for each component
  Rational energy;                                          ///< c > 0
};

/// The cuts of a box and the proofs of its parts, in preorder.
using StabilityProof = PartsIn<DegreeProof, RestProof, StickingProof>;

/// Returns whether all parts are proved at rest.
bool are_at_rest(const StabilityProof& parts);
/// Returns whether all parts are proved by sticking.
bool are_sticking(const StabilityProof& parts);
/// Returns whether all parts are proved by degree with bodies of motions that have no walls, as
/// no force is left there.
bool are_untouched(const StabilityProof& parts);

}  // namespace stickslip
