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

/// An equilibrium under one load of the plane. One at infinity has the load s u + t v alone and
/// preloads of weight 0; any multiple of it may be added to one of the same mode.
struct LoadPoint {
  HomogeneousPoint load;  ///< (s, t), or the direction
  ShortWitness witness;   ///< for point_of(load), or direction_of(load)
};

/// conv + cone of loads that share a mode; the grasp resists all of it.
using ProvedPiece = std::vector<LoadPoint>;

/// A node with two children: f(s, t, h) = f_x s + f_y t + f_h h >= 0, and < 0.
struct LoadSplit {
  HomogeneousPoint f;  ///< nonzero; here a function of points
};
/// A leaf: all loads of its cell lie in one piece.
struct HeldLeaf {
  std::size_t piece;  ///< its number
};
/// A node about motions, or about loads.
using RegionNode = std::variant<TreeNode, LoadSplit, HeldLeaf>;

/// The proof about a plane, with the evidence of certificate/FORMAT.md, section 12.
struct RegionProof {
  std::vector<ProvedPiece> pieces;  ///< their union is the set of resistible wrenches
  std::vector<RegionNode> tree;     ///< in preorder
};

/// The work of a search for a proof; reproducible.
struct RegionProofWork {
  std::size_t cells = 0;     ///< cells of the plane that were refuted
  std::size_t held = 0;      ///< cells of the plane that are in a piece
  std::size_t nodes = 0;     ///< nodes of the refutations
  std::size_t programs = 0;  ///< exact linear programs among the nodes
};

/// The limit of a proof, and who hears of its progress.
struct RegionProofOptions {
  std::size_t node_limit = 0;  ///< the limit for all refutations together; 0: none
  /// Called now and then, with the work so far.
  std::function<void(const RegionProofWork& work)> progress;
};

/// Proves the pieces that resistible_set found for this problem and plane. Undecided if the
/// limit is exceeded, or if the tree would be deeper than the format allows.
std::variant<RegionProof, Undecided> prove_region(const Problem& problem,
                                                  const WrenchPlane& plane,
                                                  const std::vector<ResistiblePiece>& pieces,
                                                  const RegionProofOptions& options = {},
                                                  RegionProofWork* work = nullptr);

}  // namespace stickslip
