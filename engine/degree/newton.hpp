// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Equilibria of one grasp by Newton's method, in doubles.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rounded_box.hpp"
#include "stickslip/engine/near_equilibrium.hpp"

namespace stickslip {

/// The equations of an equilibrium with given modes, to first order: balance, and no slip where
/// it sticks, of the motion and of friction there. O(contacts D^2).
class ModalEquations {
 public:
  /// At `near`, whose normal forces, and friction where it slips, become those of its motion.
  ModalEquations(const RoundedGrasp& grasp, NearEquilibrium& near);

  const Reals& off() const { return off_; }                ///< the load and all forces
  const Eigen::VectorXd& slips() const { return slips_; }  ///< where it sticks
  /// By how much the motion has to change for what is off, and these slips, to vanish.
  Reals motion_change(const Reals& off, const Eigen::VectorXd& slips) const;
  /// And friction where it sticks, with that change of the motion.
  Eigen::VectorXd friction_change(const Reals& off, const Reals& motion_change) const;

 private:
  Reals off_;
  Eigen::VectorXd slips_;
  Eigen::MatrixXd derivative_;  ///< of what is off
  Eigen::MatrixXd answer_;      ///< of friction to forces, of least squares
  Eigen::MatrixXd free_;        ///< motions without slip where it sticks, by columns
};

/// Newton's method on a grasp, which must outlive it.
class Newton {
 public:
  /// Of this grasp.
  explicit Newton(const RoundedGrasp& grasp) : grasp_(grasp) {}

  /// From a motion, with friction smoothed over slips that become smaller and smaller; nothing
  /// if that does not converge.
  std::optional<NearEquilibrium> solve(const Reals& start) const;
  /// In the plane, from modes that are only nearly right; what it comes to may be no
  /// equilibrium.
  NearEquilibrium settle(NearEquilibrium near) const;
  /// With the modes of one that is near: what sticks there sticks.
  std::optional<NearEquilibrium> polish(NearEquilibrium near) const;
  /// Of another grasp than that of one that is near: in the same modes, or in others; nothing
  /// where it was lost.
  std::optional<NearEquilibrium> follow(const NearEquilibrium& near) const;
  /// With what is closed at rest sticking, from rest, and from motions at random, always the
  /// same: those that differ. If there are none, and no preloads, once more with all contacts
  /// pressed at first. Of some the mode is not certain.
  std::vector<NearEquilibrium> solve_from(std::size_t starts) const;
  /// How forces answer a motion, against it, with friction smooth over slips of this size.
  Eigen::MatrixXd answer(const Reals& motion, double smooth) const;

 private:
  NearEquilibrium at_rest() const;
  double pressing(const RoundedContact& contact) const;
  std::optional<NearEquilibrium> change_modes(NearEquilibrium near) const;
  void share_out(NearEquilibrium& near) const;
  Reals force(const Reals& motion, double smooth, Eigen::MatrixXd* derivative) const;
  bool balance(Reals& d, double smooth) const;
  Reals change_with_smooth(const Reals& d, double smooth) const;

  const RoundedGrasp& grasp_;
  /// By how much deeper all contacts are pressed than they are, over the size of slips over
  /// which friction is smooth: a grasp that hangs together by its loads alone has no forces at
  /// rest.
  double press_ = 0;
};

}  // namespace stickslip
