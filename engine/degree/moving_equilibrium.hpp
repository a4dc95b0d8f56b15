// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How an equilibrium moves with the uncertain numbers of a box, in doubles: proposals for
/// walls that enclose it, for cuts, and for grasps that have none.
#pragma once

#include <vector>

#include "newton.hpp"

namespace stickslip {

/// An equilibrium followed from the middle of a box to a place in it.
struct EquilibriumPath {
  std::vector<NearEquilibrium> equilibria;  ///< some on the way, and the last one reached
  double part = 0;                          ///< of the way, reached before it was lost; 1: all
};

/// Towards this place the equilibrium is lost after this part of the way.
struct LostWay {
  RoundedBox::Place to;  ///< a corner of the box
  double part;           ///< below 1
};

/// An equilibrium of the grasp in the middle of a box.
class MovingEquilibrium {
 public:
  using Place = RoundedBox::Place;  ///< of a grasp

  /// The box must outlive it.
  MovingEquilibrium(const RoundedBox& box, NearEquilibrium middle)
      : box_(box), start_(std::move(middle)) {}

  const NearEquilibrium& start() const { return start_; }  ///< in the middle

  /// From the middle.
  EquilibriumPath follow(const Place& to) const;
  /// Corners towards which it is lost, soonest first: those that move it most along the normal
  /// or a tangent of some contact, from the middle or from where it was lost soonest before.
  std::vector<LostWay> ways_out() const;
  /// By how much half an interval of each number moves an equilibrium at a place, to first
  /// order: by columns. O(numbers D^2).
  Eigen::MatrixXd moves(const Place& place, const NearEquilibrium& here) const;
  /// By how much it has moved on the way to where it goes farthest along each of these rows,
  /// either way.
  std::vector<Reals> extremes(const Eigen::MatrixXd& rows) const;

 private:
  const RoundedBox& box_;
  NearEquilibrium start_;
};

}  // namespace stickslip
