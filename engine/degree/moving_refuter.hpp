// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Refutes the walls of a parallelepiped of motions by virtual twists that move with the point
/// (certificate/FORMAT.md, section 4). That is for boxes: a wall far from all equilibria of a
/// box is refuted in few pieces, where twists that do not move need very many. Where geometry
/// is certain, as of single grasps and in margins, contacts can be split, and twists that do
/// not move take less time and space.
#pragma once

#include "engine/motion/tree_walk.hpp"
#include "engine/search/moving_twists.hpp"
#include "wall_refuter.hpp"

namespace stickslip::degree_detail {

/// Refutes walls for any law that is no margin. A piece of a wall without a leaf is cut in two
/// across that coordinate of the parallelepiped along which the points that matter lie widest.
class MovingRefuter final : public LawRefuter {
 public:
  using LawRefuter::LawRefuter;

  bool refute(DegreeProof& proof, std::size_t wall, bool second,
              std::size_t node_limit) override;
  /// Returns how far from the middle of the parallelepiped, in the law's units, the point of
  /// the last wall that was not refuted is where leaves fail first.
  const Reals& lost_at() const { return lost_at_; }
  /// Returns the bound of the best leaf for this point alone: below 0 if no grasp of the box
  /// has an equilibrium there for which doubles see no reason.
  double bound_at(const DegreeProof& proof, const Reals& way) const;

 private:
  struct Piece {
    MotionRegion region;
    search_detail::MovingTwists::Coordinates guess;  ///< those of the whole's leaf
  };
  using Branch = BranchOf<TreeNode, Piece>;

  std::optional<Branch> examine(const DegreeProof& proof, const PullRule* pull,
                                const Piece& piece, std::size_t depth);

  Reals lost_at_;
};

}  // namespace stickslip::degree_detail
