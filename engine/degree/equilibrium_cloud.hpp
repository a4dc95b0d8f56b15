// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Where the equilibria of the grasps of a box lie, by samples, and coordinates of motions that
/// suit them; in doubles.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "moving_equilibrium.hpp"
#include "stickslip/engine/force_span.hpp"

namespace stickslip::degree_detail {

/// Returns the value in the middle, of two the larger; 0 if there are none.
double median_of(std::vector<double> values);

/// Coordinates of motions around an equilibrium: first along the slips of the contacts that
/// stick or slip little, which friction is against; then across forces. Within each of the two
/// they are the principal axes of the cloud.
struct CloudCoordinates {
  Eigen::MatrixXd rows;    ///< the coordinates, as functions of motions, by rows
  Eigen::VectorXd extent;  ///< how far the cloud reaches, by coordinate
  double press;            ///< how far a typical contact that presses is pressed in

  /// Takes an equilibrium of the grasp in the middle of a box, and how far from it equilibria
  /// of others are.
  CloudCoordinates(const RoundedGrasp& middle, const ForceSpan& span,
                   const NearEquilibrium& near, const std::vector<Reals>& cloud);
};

}  // namespace stickslip::degree_detail
