// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Equilibria of one grasp by Newton's method, in doubles.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "rounded_box.hpp"
#include "stickslip/engine/near_equilibrium.hpp"

namespace stickslip {

/// The equations of an equilibrium with given modes, to first order, for the motion and for the
/// friction of the contacts that stick: balance, and no slip at these. O(contacts D^2).
class ModalEquations {
 public:
  /// Takes the equations at `near`. Its normal forces, and its friction where it slips, become
  /// those of its motion.
  ModalEquations(const RoundedGrasp& grasp, NearEquilibrium& near);

  const Reals& off() const { return off_; }                ///< residual: load and all forces
  const Eigen::VectorXd& slips() const { return slips_; }  ///< the slips of contacts that stick
  /// Returns the Newton step of the motion that cancels the residual and these slips.
  Reals motion_change(const Reals& off, const Eigen::VectorXd& slips) const;
  /// Returns the step of the friction of contacts that stick, with that step of the motion.
  Eigen::VectorXd friction_change(const Reals& off, const Reals& motion_change) const;

 private:
  Reals off_;
  Eigen::VectorXd slips_;
  Eigen::MatrixXd derivative_;  ///< the derivative of the residual
  Eigen::MatrixXd answer_;      ///< from forces to friction, by least squares
  Eigen::MatrixXd free_;        ///< motions without slip of contacts that stick, by columns
};

/// Newton's method on a grasp.
class Newton {
 public:
  /// The grasp must outlive this.
  explicit Newton(const RoundedGrasp& grasp) : grasp_(grasp) {}

  /// Starts from a motion, with friction smoothed over slips that become smaller and smaller.
  /// Returns nothing if that does not converge.
  std::optional<NearEquilibrium> solve(const Reals& start) const;
  /// Does the same by SmoothNewton. It converges more often, and the modes that it finds are
  /// less certain.
  std::optional<NearEquilibrium> solve_smoothly(const Reals& start) const;
  /// Starts, in the plane, from modes that are only nearly right. The result may be no
  /// equilibrium.
  NearEquilibrium settle(NearEquilibrium near) const;
  /// Returns the equilibrium with the modes of one that is near: contacts that stick there
  /// stick. Returns nothing if that does not converge or takes more friction than there is.
  std::optional<NearEquilibrium> polish(NearEquilibrium near) const;
  /// Starts from an equilibrium of another grasp: returns one of this grasp in the same modes,
  /// or in others; nothing if it was lost.
  std::optional<NearEquilibrium> follow(const NearEquilibrium& near) const;
  /// Returns the different equilibria that are found from rest with all closed contacts
  /// sticking; if `starts` is not 0, from rest with smooth laws, which mostly finds the one
  /// nearest to rest; and by solve() from `starts` motions: rest, then fixed pseudo-random
  /// ones. If there are none, and no preloads, searches once more with all contacts pressed at
  /// first. The modes of some are not certain. Ends once there are `enough`.
  std::vector<NearEquilibrium> solve_from(std::size_t starts,
                                          std::size_t enough = SIZE_MAX) const;
  /// Returns the first equilibrium that is found by solve_from() and then by solve_smoothly()
  /// from other motions, which takes long where there is none.
  std::optional<NearEquilibrium> solve_thoroughly(std::size_t starts) const;
  /// Returns how forces answer a motion, against it, with friction smooth over slips of this
  /// size: minus the derivative of their sum.
  Eigen::MatrixXd answer(const Reals& motion, double smooth) const;

 private:
  NearEquilibrium at_rest() const;
  std::optional<NearEquilibrium> sharpened(const std::optional<Reals>& motion) const;
  NearEquilibrium at(const Reals& d, double smooth) const;
  double pressing(const RoundedContact& contact) const;
  std::optional<NearEquilibrium> change_modes(NearEquilibrium near) const;
  void share_out(NearEquilibrium& near) const;
  Reals force(const Reals& motion, double smooth, Eigen::MatrixXd* derivative) const;
  bool balance(Reals& d, double smooth) const;
  Reals change_with_smooth(const Reals& d, double smooth) const;

  const RoundedGrasp& grasp_;
  /// The depth by which all contacts are pressed more than they are, over the size of slips
  /// over which friction is smooth. A grasp that hangs together by its loads alone has no
  /// forces at rest, and needs it.
  double press_ = 0;
};

}  // namespace stickslip
