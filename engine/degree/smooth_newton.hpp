// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Newton's method with smooth laws, in doubles: it converges where kinks stop Newton, and
/// finds equilibria only about.
#pragma once

#include <optional>

#include "rounded_box.hpp"

namespace stickslip {

/// Newton's method for a grasp whose friction and normal forces are smooth near 0: of the
/// equilibria of a grasp it finds one that is near, whatever modes end on the way, but only
/// about.
class SmoothNewton {
 public:
  /// The part of the reach over which the laws are smooth in the end.
  static constexpr double kLeast = 1e-6;

  /// The grasp must outlive this.
  explicit SmoothNewton(const RoundedGrasp& grasp) : grasp_(grasp) {}

  /// Returns the motion of an equilibrium whose laws are smooth over the part kLeast of the
  /// reach, from smoother ones on that are smooth over the part `first`. Returns nothing if it
  /// was lost.
  std::optional<Reals> settle(Reals start, double first) const;
  /// Returns that of one near the motion of an equilibrium of another grasp: begins with laws
  /// that are hardly smooth, and with smoother ones where that fails.
  std::optional<Reals> follow(const Reals& from) const;

  /// Returns the sum of all wrenches at a motion, with laws that are smooth over so much of it;
  /// `derivative`, if given, becomes how that changes with the motion.
  Reals force(const Reals& d, double smooth, Eigen::MatrixXd* derivative = nullptr) const;
  /// Moves d, in so many steps at most, to where that sum is 0; returns false if it is lost.
  bool balance(Reals& d, double smooth, int steps) const;

 private:
  Reals change_with(const Reals& d, double smooth) const;

  const RoundedGrasp& grasp_;
};

}  // namespace stickslip
