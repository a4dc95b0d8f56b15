// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A ball of loads, or the part of one that lies in a box (certificate/FORMAT.md, section 6).
#pragma once

#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/engine/reals.hpp"

namespace stickslip {

/// Loads B z that are added to one certain load. Here z is a force and a torque at the ball's
/// point, and lies both in a box and in the ball.
struct BallPart {
  Rational radius;     ///< the radius R of the ball, a force
  Rational length;     ///< the length that torques are divided by
  std::size_t forces;  ///< the number of components of z that are forces, 2 or 3
  /// The columns of B: how the loaded body moves at the ball's point, a function of motions for
  /// each component of z.
  std::vector<RationalRow> motion;
  std::vector<Interval> parts;  ///< the box, an interval for each component of z
  Eigen::MatrixXd rounded{};    ///< the rows of `motion` in doubles, in the units of a law

  /// Returns the whole ball of a box of grasps. Requires that the box has one.
  static BallPart all_of(const GraspBox& box);

  /// Returns the load B z.
  RationalRow load(const RationalRow& z) const;
  /// Returns the load B z in the law's units.
  Reals load(const Eigen::VectorXd& z) const { return rounded.transpose() * z; }
  /// Returns a bound of the work that any of the loads does on a virtual twist: the smaller of
  /// the bounds from the box and from the ball, which is what checkers compute.
  Rational most_work(const Row& y) const;
  /// Returns the z, in doubles, at which the smaller of these two bounds is attained. The twist
  /// is in the law's units.
  Eigen::VectorXd worst(const Reals& y) const;
  /// Returns a z, in doubles, at which a linear function of z is large. It lies in the box, and
  /// in the ball too if some point of the box does.
  Eigen::VectorXd farthest(const Eigen::VectorXd& function) const;
  /// Returns z itself if it is in the ball; else z moved towards the point of the box that is
  /// nearest to 0, as far as the ball's surface. In doubles.
  Eigen::VectorXd pulled_in(const Eigen::VectorXd& z) const;
  /// Returns the z of the box that is nearest to 0. If any z of the box is in the ball, this
  /// one is.
  RationalRow nearest() const;
  /// Returns the typical size of a component of z as a multiple of that of a force: 1 for a
  /// force, the length for a torque.
  double unit(std::size_t component) const;
};

}  // namespace stickslip
