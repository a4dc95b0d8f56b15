// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How much work verdicts about a box are worth, where a caller sets no limits.
///
/// One body in the plane moves in three coordinates: its trees are small, and an engine of its
/// own decides single grasps exactly, in milliseconds. In space and of several bodies a single
/// grasp takes a search as long as that of a box does. Newton's method in doubles says much
/// sooner what will probably be found. So a tree may have more nodes there, but fewer are
/// grown: fewer single grasps are decided, and doubles choose which.
#pragma once

#include <cstddef>

#include "stickslip/core/box.hpp"

namespace stickslip::box_detail {

/// The effort for the grasps of a box.
struct Effort {
  /// \{ For one verdict: the most nodes of a tree about all motions, how many walls share as
  /// many, and how many such trees a box may take before it is cut no more.
  std::size_t nodes;
  std::size_t walls;
  std::size_t trees;
  /// \}
  /// The nodes of a proof that is tried before counterexamples are sought; 0 if none is.
  std::size_t quick_nodes;
  bool rest_first;  ///< whether equilibria near rest are tried before others are sought
  bool may_refine;  ///< whether lengths of one grasp are enclosed in more bits, again and again
  /// The most contacts of one grasp whose exact equilibria are sought before proofs by degree.
  std::size_t exact_contacts;
  /// The most numbers of a box for which single grasps at the ends of each are decided.
  std::size_t single_ends;

  /// \{ The nodes of a proof if many are sought, and of a single grasp; with 0 as for one.
  std::size_t nodes_of_many;
  std::size_t nodes_of_single;
  /// \}
  bool decides_singles;    ///< whether single grasps are decided without asking doubles first
  bool margins_come_soon;  ///< whether margins of single grasps are exact and found soon
  bool cuts_boxes;         ///< whether radii seek proofs of a box in parts, too
  bool retries;            ///< whether radii seek proofs again between a failure and the border
  /// \{ The most changes of preloads that a search for better ones tries: for the least, and
  /// for those that hold the largest ball.
  std::size_t tries;
  std::size_t tries_for_ball;
  /// \}
  int last_step;  ///< how many times smaller than the accuracy the last changes may be
};

/// Returns the effort for a box, or for one grasp.
Effort effort_for(const GraspBox& box);

}  // namespace stickslip::box_detail
