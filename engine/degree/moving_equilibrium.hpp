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
  double part = 0;  ///< the part of the way that was reached before it was lost; 1: all
};

/// An equilibrium of the grasp in the middle of a box.
class MovingEquilibrium {
 public:
  using Place = RoundedBox::Place;  ///< the place of a grasp

  /// The box must outlive it.
  MovingEquilibrium(const RoundedBox& box, NearEquilibrium middle)
      : box_(box), start_(std::move(middle)) {}

  const NearEquilibrium& start() const { return start_; }  ///< the equilibrium in the middle

  /// Follows the equilibrium from the middle to this place.
  EquilibriumPath follow(const Place& to) const;
  /// Returns how far half an interval of each number moves an equilibrium at a place, to first
  /// order: a column for each number. O(numbers D^2).
  Eigen::MatrixXd moves(const Place& place, const NearEquilibrium& here) const;
  /// Returns the moves of the equilibrium on the way to where it goes farthest along each of
  /// these rows, either way.
  std::vector<Reals> extremes(const Eigen::MatrixXd& rows) const;
  /// Returns how far the equilibrium moves to so many fixed pseudo-random places, about, where
  /// it is not lost. Two of three are corners of the box, with normals turned as far as they
  /// may.
  std::vector<Reals> cloud(std::size_t places) const;

 private:
  const RoundedBox& box_;
  NearEquilibrium start_;
};

}  // namespace stickslip
