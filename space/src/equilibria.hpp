// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Equilibria of one grasp in space: near ones in doubles, and exact ones from these.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "space_model.hpp"
#include "stickslip/search/tree_search.hpp"
#include "stickslip/space/spatial_verdict.hpp"

namespace stickslip::space_detail {

using EigenVector6 = Eigen::Matrix<double, 6, 1>;
using EigenMatrix6 = Eigen::Matrix<double, 6, 6>;

using SlipMatrix = Eigen::Matrix<double, 3, 6>;

/// S.
inline SlipMatrix slip_matrix(const CornerRow& row) {
  SlipMatrix s;
  for (Eigen::Index k = 0; k < 3; ++k) {
    s.row(k) = row.slip_rounded[static_cast<std::size_t>(k)];
  }
  return s;
}

/// A motion at which forces nearly balance the load, in the model's units.
struct NearEquilibrium {
  EigenVector6 motion;            ///< d
  std::vector<double> normal;     ///< a by contact
  std::vector<Double3> friction;  ///< f by contact
  std::vector<char> sticks;       ///< whether the slip is nearly 0, of contacts that are closed
};

/// Of a relaxed equilibrium.
inline NearEquilibrium near(const RelaxedEquilibrium& relaxed) {
  return {relaxed.motion, relaxed.normal, relaxed.friction, relaxed.sticks};
}

/// All functions are of a model of one point, or of the middle of a box.
class NewtonMethod {
 public:
  explicit NewtonMethod(const SpaceModel& model) : model_(model) {}

  /// From a motion, with friction smoothed over slips that become smaller and smaller; nothing
  /// if that does not converge.
  std::optional<NearEquilibrium> solve(const EigenVector6& start) const;
  /// By Newton's method with the modes of one that is near: what sticks there sticks.
  std::optional<NearEquilibrium> polish(NearEquilibrium near) const;
  /// Of another model than that of one that is near: in the same modes, or in others.
  std::optional<NearEquilibrium> follow(const NearEquilibrium& near) const {
    if (auto found = polish(near)) return found;
    auto found = solve(near.motion);
    return found ? polish(std::move(*found)) : std::nullopt;
  }
  /// Friction where it sticks, with the same sum: the largest share of what there may be is
  /// made small, so that it holds with some to spare.
  void share_out(NearEquilibrium& near) const;
  /// With what is closed at rest sticking, from rest, and from motions at random, always the
  /// same: those that differ.
  std::vector<NearEquilibrium> solve_from(std::size_t starts) const;

 private:
  NearEquilibrium at_rest() const;
  /// Load and forces with friction smoothed over slips of this size, and the derivative.
  EigenVector6 force(const EigenVector6& motion, double smooth, EigenMatrix6* derivative) const;

  const SpaceModel& model_;
};

/// Directions across n: two of its rational tangents.
std::array<Vector3, 2> tangents_of(const Vector3& n);

/// An exact equilibrium with these modes, if there is one: none may slip where friction acts.
std::optional<SpatialWitness> exact_witness(const SpaceModel& model,
                                            const NearEquilibrium& near);

}  // namespace stickslip::space_detail
