// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Statics as rows: the columns of the forces that hold one grasp, of any number of bodies.
///
/// Each body has coordinates about a point of its own, amid its contacts: its motion y is that
/// of this point, and torques are about it. So numbers are short, and a body far from the
/// origin is as any other. Joints that are held leave out coordinates.
///
/// A limit a <= A of a contact's force is one more coordinate, after those of motions: in it the
/// contact has 1, the load -A, and what is left below the limit, a force s >= 0 of its own, 1.
/// A motor of any torque from -A to A pushes with a from 0 to 2 A, against -A of the load. So
/// forces are in cones still; and a motion y, with numbers q >= 0 of these coordinates, proves
/// that no forces balance the load if it does more work than the sum of A q, and the work of
/// each contact is -q or more for each unit of a.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/engine/rigid_force.hpp"
#include "stickslip/lp/cone_program.hpp"

namespace stickslip::statics_detail {

/// The forces of a contact, ratchet or motor: a times `normal` and c_k times `slips[k]`, with a
/// >= 0 and sum c_k^2 squares[k] <= squared_most a^2.
struct ForceCone {
  /// The index of the contact, ratchet or motor with a limit; nothing for the room that is left
  /// below a limit.
  std::optional<std::size_t> element{};
  SparseRow normal{};              ///< N, in the model's coordinates
  std::vector<SparseRow> slips{};  ///< the wrenches of `directions`; empty without friction
  std::vector<RationalRow> directions{};  ///< an orthogonal basis of friction forces
  RationalRow squares{};                  ///< |d_k|^2 of each direction
  Rational squared_most{0};               ///< (mu L)^2

  /// Returns |f|^2 of a force of the cone.
  Rational squared_friction(const RationalRow& force) const;
  /// Returns |S y|^2 of a motion.
  Rational squared_slip(const RationalRow& y) const;
};

/// Forces of a cone: a and then c_k. Without an entry for friction there is none.
using ConeForce = RationalRow;

/// Returns the load of one grasp.
RationalRow wrench_of_point(const GraspBox& grasp);
/// Returns the same with what springs without stiffness exert.
RationalRow wrench_with_springs(const GraspBox& grasp);

/// The statics of one grasp, with all friction multiplied by a factor.
class StaticsModel {
 public:
  /// Springs with stiffness hold joints, unless `springs_hold` is false: then all coordinates
  /// are free, and these springs are none of the model's.
  StaticsModel(const GraspBox& grasp, const Rational& friction_factor,
               bool springs_hold = true);

  std::size_t size() const { return size_; }  ///< the number of the model's coordinates
  const std::vector<ForceCone>& cones() const { return cones_; }  ///< what pushes
  /// Returns a load in the model's coordinates, without what springs exert.
  RationalRow load_of(const RationalRow& wrench) const;
  /// Returns the load of the grasp with what springs without stiffness exert.
  const RationalRow& load() const { return load_; }
  /// Returns whether a coordinate is of a body, and which others are of the same.
  const std::vector<std::size_t>& bodies() const { return bodies_; }
  /// Returns, by coordinate, what torques are divided by to compare with forces: a power of
  /// two, 1 for a force.
  const std::vector<double>& arms() const { return arms_; }

  /// Returns the columns in doubles, of cones that are all the same: those of z_0 >= |z_1..|.
  ConePair rounded(const RationalRow& load) const;
  /// Returns the factor from z_k of that to the coefficient of column k.
  double scale(const ForceCone& cone, std::size_t column) const;

  /// Returns the motion of the grasp that is this one of the model.
  RationalRow state_of(const RationalRow& y) const;
  /// Returns a positive multiple of it and of the numbers of limits, one for each element of
  /// GraspBox::force_limits(), in coprime integers. That of a motor is at least the size of its
  /// turn.
  RationalRow motion_of(const RationalRow& y) const;
  /// Returns whether no force of the cone opposes the motion.
  static bool is_unopposed(const ForceCone& cone, const RationalRow& y);
  /// Returns whether the force is in the cone.
  static bool is_in(const ForceCone& cone, const ConeForce& force);
  /// Returns the forces by element of the grasp, with those of springs, which balance the load.
  /// `wrench` is that load without what springs without stiffness exert, which is `weight`
  /// times their forces.
  RigidForces forces_of(const std::vector<ConeForce>& forces, const RationalRow& wrench,
                        const Rational& weight = 1) const;

 private:
  void add_contact(const UncertainContact& contact, std::size_t element,
                   const Rational& friction_factor);
  SparseRow row_of(const UncertainContact& contact, const RationalRow& wrench) const;
  SparseRow shifted(SparseRow row) const;
  SparseRow held(SparseRow row) const;
  void find_centres();
  void hold_joints(bool springs_hold);
  void add_limits();

  const GraspBox& grasp_;
  std::size_t size_ = 0;
  std::size_t twist_ = 3;             ///< coordinates of a body: 3 or 6
  std::size_t free_ = 0;              ///< coordinates of all bodies that are no links
  std::size_t motions_ = 0;           ///< coordinates of motions; those of limits follow
  std::vector<RationalRow> centres_;  ///< by body that is no link
  std::optional<std::vector<RationalRow>> joints_;  ///< motions of joints that are not held
  std::vector<ForceCone> cones_;
  /// The limits: the cone of each among `cones_`, and A.
  std::vector<std::pair<std::size_t, Rational>> limits_;
  RationalRow load_;
  std::vector<std::size_t> bodies_;
  std::vector<double> arms_;
};

}  // namespace stickslip::statics_detail
