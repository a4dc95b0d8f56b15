// SPDX-License-Identifier: MIT
/// \file
/// Regions of a plane of loads (FORMAT.md §12): the pieces, which are convex and by equilibria
/// of one mode at their corners resisted. (The rest of the plane is a tree's, tree.hpp.)
///
/// The *load part* of a point x = (d, h, s, t) is (h, s, t).
#pragma once

#include <cstdint>
#include <vector>

#include "cone.hpp"
#include "witness.hpp"

namespace stickslip_check {

Form load_part(const Form& x);

/// The cone of the load parts of some points: the sums of multiples >= 0 of them.
class Piece {
 public:
  explicit Piece(const std::vector<Witness>& points);

  bool contains(const Form& load) const;

 private:
  Cone faces_{3};  ///< the dual cone: functions that are nowhere below 0 on the piece
};

/// The pieces, checked as they come. `question` must outlive this.
class Pieces {
 public:
  explicit Pieces(const Question& question) : question_(question) {}

  /// Throws Rejected.
  void visit(const std::vector<Witness>& points);
  /// Those that were visited.
  std::vector<Piece> take() { return std::move(pieces_); }

 private:
  const Question& question_;
  ForceSum sum_;
  std::vector<Piece> pieces_;
};

}  // namespace stickslip_check
