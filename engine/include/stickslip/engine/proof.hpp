// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What proves verdicts without stating an equilibrium: trees that refute regions, and bodies
/// of motions that hold an equilibrium (certificate/FORMAT.md, sections 4 to 7). For motions of
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

/// Where slips have one dimension three children: slip +, 0, - at a contact; else two: s = 0,
/// and s strict.
struct SlipSplit {
  ContactId contact;  ///< split by its slip
};
/// Two children: closed, open.
struct SeparationSplit {
  ContactId contact;  ///< split by v_i
};
/// Two children: plane.x >= 0, plane.x <= 0, of points x = (d, h, l).
struct PlaneCut {
  Row plane;  ///< nonzero
};
/// A virtual twist on which no force of the region makes up for the load. It is 0 where the
/// region is void: no solution can lie there, or another child covers it.
struct TwistLeaf {
  Row twist;  ///< y
};

/// Four kinds of split, and a leaf.
using TreeNode = std::variant<SlipSplit, SeparationSplit, PlaneCut, TwistLeaf, PartSplit>;
/// Trees in preorder, one after another.
using Trees = std::vector<TreeNode>;

/// How many nodes are leaves.
std::size_t leaf_count(const Trees& trees);

/// A parallelepiped of motions {d : |E_j.(d - d0)| <= 1} or a simplex {d : E_j.(d - d0) <= 1},
/// along which motions that no E sees go without end.
struct ConvexBody {
  RationalRow twist{};               ///< d0, inside
  bool is_simplex = false;           ///< and then there is one E more
  std::vector<RationalRow> walls{};  ///< E, by rows

  /// Those of a parallelepiped in the order E_1 +, E_1 -, E_2 +, ...
  std::size_t wall_count() const { return is_simplex ? walls.size() : 2 * walls.size(); }
};

/// There is an equilibrium in a body of motions, of every grasp of a part of a box.
struct DegreeProof : ConvexBody {
  std::vector<RationalRow> direction{};  ///< A, by rows
  Trees trees{};  ///< list 1 unless it is not needed, and list 2; one for each wall
};

/// Nothing moves: friction at rest f0 + sum of G_l z_l, with whatever |z_l| <= reach_l balances
/// a grasp of the box. A force of friction has as many coordinates as a slip.
struct RestProof {
  /// G of a contact: the friction with which it answers a unit of each component of a wrench.
  struct Answer {
    ContactId contact;                ///< whose friction it is
    std::vector<RationalRow> forces;  ///< by component, across its normal
  };
  std::vector<std::pair<ContactId, RationalRow>> friction;  ///< f0 by contact, increasing
  std::vector<Answer> answers;                              ///< by contact, increasing
  RationalRow reach;                                        ///< >= 0
};

/// There is an equilibrium near a motion d0 at which contacts stick: f0, with answers of
/// friction and of normal forces, balances every grasp of the box, and friction has more to
/// spare than what is off takes away (certificate/FORMAT.md, section 6, "Stable: sticking").
struct StickingProof {
  /// H of a contact: how much more it presses for a unit of each component of a wrench.
  struct Press {
    ContactId contact;   ///< that presses
    RationalRow forces;  ///< by component
  };
  RationalRow motion;                                       ///< d0
  std::vector<std::pair<ContactId, RationalRow>> friction;  ///< f0 by contact, increasing
  std::vector<Press> presses;                               ///< by contact, increasing
  std::vector<RestProof::Answer> answers;                   ///< by contact, increasing
  RationalRow reach;                                        ///< > 0
  Rational energy;                                          ///< c > 0
};

/// Cuts of a box and proofs of its parts, in preorder.
using StabilityProof = PartsIn<DegreeProof, RestProof, StickingProof>;

/// Whether all parts are proved at rest.
bool are_at_rest(const StabilityProof& parts);
/// Whether all parts are proved by sticking.
bool are_sticking(const StabilityProof& parts);

}  // namespace stickslip
