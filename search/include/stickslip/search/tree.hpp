// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Trees that refute, for states of any number of coordinates (certificate/FORMAT.md, sections
/// 4 to 7).
#pragma once

#include <variant>
#include <vector>

#include "stickslip/core/row.hpp"
#include "stickslip/equilibrium/part.hpp"
#include "stickslip/equilibrium/verdict.hpp"
#include "stickslip/motion/degree_proof.hpp"

namespace stickslip {

/// Two children: plane.x >= 0, plane.x <= 0, of points x = (d, h, l).
struct PlaneCut {
  Row plane;  ///< nonzero
};
/// A virtual twist on which no force of the region makes up for the load; 0 where the region is
/// void.
struct TwistLeaf {
  Row twist;  ///< y
};

/// Four kinds of split, and a leaf. Where slips have one dimension a SlipSplit has three
/// children, +, 0 and -; else two: s = 0, and s strict.
using TreeNode = std::variant<SlipSplit, SeparationSplit, PlaneCut, TwistLeaf, PartSplit>;
/// Trees in preorder, one after another.
using Trees = std::vector<TreeNode>;

/// How many nodes are leaves.
std::size_t leaf_count(const Trees& trees);

/// Of every grasp of a part of a box.
using DegreeProof = DegreeProofIn<TreeNode>;

}  // namespace stickslip
