// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The resistible wrenches of a plane as a theorem (certificate/FORMAT.md, section 12): convex
/// pieces, each resisted because there are equilibria of one mode at its corners, and a tree
/// that refutes every load outside of them.
///
/// **Method.** The pieces are those of resistible_set. A binary space partition of the plane,
/// first by lines of the region's border and then by those of pieces, leads to cells that lie
/// in one piece or meet none. The latter are refuted by branch and bound over the motions with
/// all of the cell as loads (engine/search/law_forces.hpp); where doubles fail, as at cells
/// that touch the region, the exact program of region_program.hpp decides. Borders of cells
/// that belong to another cell are strict functions.
#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "stickslip/engine/proof.hpp"
#include "stickslip/measures/resistible_set.hpp"

namespace stickslip {

/// An equilibrium under one load of the plane; or at infinity, where the load is s u + t v
/// alone, preloads have no weight, and any multiple may be added to one of the same mode.
struct LoadPoint {
  HomogeneousPoint load;  ///< (s, t), or the direction
  ShortWitness witness;   ///< for point_of(load), or direction_of(load)
};

/// conv + cone of loads that share a mode: all of it is resisted.
using ProvedPiece = std::vector<LoadPoint>;

/// Two children: f(s, t, h) = f_x s + f_y t + f_h h >= 0, and < 0.
struct LoadSplit {
  HomogeneousPoint f;  ///< nonzero; here a function of points
};
/// All loads of the region lie in this piece.
struct HeldLeaf {
  std::size_t piece;  ///< its number
};
/// A node about motions, or about loads.
using RegionNode = std::variant<TreeNode, LoadSplit, HeldLeaf>;

/// With the evidence of certificate/FORMAT.md, section 12.
struct RegionProof {
  std::vector<ProvedPiece> pieces;  ///< whose union is the set of resistible wrenches
  std::vector<RegionNode> tree;     ///< in preorder
};

/// What the search for a proof did; reproducible.
struct RegionProofWork {
  std::size_t cells = 0;     ///< of the plane, refuted
  std::size_t held = 0;      ///< of the plane, in a piece
  std::size_t nodes = 0;     ///< of the refutations
  std::size_t programs = 0;  ///< exact linear programs among them
};

/// How far to go, and whom to tell.
struct RegionProofOptions {
  std::size_t node_limit = 0;  ///< of all refutations together; 0: none
  /// Called now and then, with the work so far.
  std::function<void(const RegionProofWork& work)> progress;
};

/// Of the pieces that resistible_set found for this problem and plane. Undecided when the limit
/// is exceeded, or the tree would be deeper than the format allows.
std::variant<RegionProof, Undecided> prove_region(const Problem& problem,
                                                  const WrenchPlane& plane,
                                                  const std::vector<ResistiblePiece>& pieces,
                                                  const RegionProofOptions& options = {},
                                                  RegionProofWork* work = nullptr);

}  // namespace stickslip
