// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How an equilibrium moves with the uncertain numbers of a box, in doubles: proposals for
/// walls that enclose it, for cuts, and for grasps that have none.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "box_law.hpp"
#include "stickslip/equilibrium/search/rounded_equilibrium.hpp"

namespace stickslip::box_detail {

/// An equilibrium in doubles.
struct Equilibrium {
  Eigen::Vector3d motion;
  Eigen::VectorXd shares;  ///< of friction, in [-1, 1], by contact
  std::vector<bool> sticks;
};

/// An equilibrium followed from the middle of a box to a place in it.
struct EquilibriumPath {
  std::vector<Equilibrium> equilibria;  ///< some on the way, and the last one reached
  double part = 0;                      ///< of the way, reached before it was lost; 1: all
};

/// Towards this place the equilibrium is lost after this part of the way.
struct LostWay {
  Eigen::VectorXd to;
  double part;
};

/// A *place* has a number from -1 to 1 for each uncertain number: its low end to its high end.
/// Rotations are times `length`, torques over it.
class MovingEquilibrium {
 public:
  using Motion = Eigen::Vector3d;
  using Place = Eigen::VectorXd;

  /// Of an equilibrium of the middle, of which this is the model.
  MovingEquilibrium(const ParameterBox& box, const Law& middle, const RoundedEquilibrium& near);

  const std::vector<ParameterId>& numbers() const { return numbers_; }
  const Equilibrium& start() const { return start_; }  ///< in the middle
  Place middle() const { return Place::Zero(static_cast<Eigen::Index>(numbers_.size())); }

  /// From the middle.
  EquilibriumPath follow(const Place& to) const;
  /// Corners towards which it is lost, soonest first: those that move it most along the normal
  /// or the tangent of some contact, from the middle or from where it was lost soonest before.
  std::vector<LostWay> ways_out() const;
  /// By how much half an interval of each number moves an equilibrium at a place, to first
  /// order: by columns.
  Eigen::Matrix3Xd moves(const Place& place, const Equilibrium& here) const;
  /// All wrenches together on the middle at a motion; where a contact sticks it has the share
  /// of the start.
  Motion force(const Motion& motion) const;

 private:
  struct Contact {
    Motion normal;
    Motion tangent;
    double friction;
    double preload;
    double stiffness;
  };
  struct Grasp {
    std::vector<Contact> contacts;
    Motion load;
  };
  struct Range {
    double middle;
    double half;
  };

  /// The equilibrium to which a Newton method leads: which contacts are closed and which stick
  /// is guessed from the last motion and forces, until it is right.
  std::optional<Equilibrium> near(const Place& place, const Equilibrium& start) const;
  Contact contact_at(std::size_t index, const std::array<double, 6>& numbers) const;
  std::array<double, 6> numbers_at(std::size_t contact, const Place& place) const;
  Grasp at(const Place& place) const;
  double bounded_share(const Contact& contact, const Motion& motion, double share) const;
  Eigen::Matrix3d derivative(const Grasp& grasp, const Motion& motion,
                             const Eigen::VectorXd& shares,
                             const std::vector<bool>& sticks) const;

  double force_;
  double travel_ = 1;  ///< a typical motion
  Equilibrium start_;
  std::vector<ParameterId> numbers_;
  std::vector<std::array<Eigen::Index, 6>> places_;  ///< of a contact's numbers; -1: certain
  std::array<Eigen::Index, 3> load_places_;
  std::vector<std::array<Range, 6>> ranges_;
  std::vector<std::array<double, 2>> directions_;  ///< n
  std::array<Range, 3> load_;
};

}  // namespace stickslip::box_detail
