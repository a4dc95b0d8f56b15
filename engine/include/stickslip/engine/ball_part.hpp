// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A ball of loads, or what a box cuts from it (certificate/FORMAT.md, section 6).
#pragma once

#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/engine/reals.hpp"

namespace stickslip {

/// Loads B z beside one that is certain: z, a force and a torque at the ball's point, lies in a
/// box and in the ball.
struct BallPart {
  Rational radius;                  ///< of the ball
  Rational length;                  ///< torques are over it
  std::size_t forces;               ///< components of z that are of a force, 2 or 3
  std::vector<RationalRow> motion;  ///< B by columns: motions of the body at the point
  std::vector<Interval> parts;      ///< the box, by component of z
  Eigen::MatrixXd rounded{};        ///< `motion` by rows, in the units of a law

  /// All of the ball that a box of grasps has. Requires that it has one.
  static BallPart all_of(const GraspBox& box);

  /// B z.
  RationalRow load(const RationalRow& z) const;
  /// The same in the law's units.
  Reals load(const Eigen::VectorXd& z) const { return rounded.transpose() * z; }
  /// A bound of the work of all loads on a virtual twist: the smaller of those of the box and
  /// of the ball, as checkers have it.
  Rational most_work(const Row& y) const;
  /// Where the one that is smaller is attained, in doubles, for a twist in the law's units.
  Eigen::VectorXd worst(const Reals& y) const;
  /// Where a linear function of z, in doubles, is large: of the box and in the ball, if any of
  /// the box is.
  Eigen::VectorXd farthest(const Eigen::VectorXd& function) const;
  /// z in the ball, in doubles: itself, or moved towards the one of the box that is nearest to
  /// 0.
  Eigen::VectorXd pulled_in(const Eigen::VectorXd& z) const;
  /// The z of the box that is nearest to 0, which is in the ball if any is.
  RationalRow nearest() const;
  /// A typical size over that of a force, of a component of z: 1 or the length.
  double unit(std::size_t component) const;
};

}  // namespace stickslip
