// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The method of Haas-Heger et al. (RSS 2018) as one would write it in a day: in doubles, with
/// one tolerance. What `stickslip crosscheck` is for; never evidence of anything.
///
/// Algorithm 1 enumerates the slip states by splitting sign vectors, one contact after another,
/// with a linear program for each half (here for edges and vertices too, so that Steps 2 and 3
/// are not needed). Algorithm 2 solves the system of each state; contacts may detach, so every
/// set of closed contacts is tried. GLPK solves the programs.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "stickslip/engine/question.hpp"

namespace stickslip::bench {

/// A contact with its normal brought to length 1.
struct FloatContact {
  Eigen::Vector2d normal;
  Eigen::Vector3d normal_row;   ///< N
  Eigen::Vector3d tangent_row;  ///< T
  double friction;
  double stiffness;
  double preload;
};

struct FloatQuestion {
  std::vector<FloatContact> contacts;
  Eigen::Vector3d load;
  NormalLaw law;
};

/// The question rounded to doubles, once.
FloatQuestion to_float(const Question& question);

struct FloatAnswer {
  bool stable = false;
  Eigen::Vector3d twist = Eigen::Vector3d::Zero();  ///< if stable
  std::vector<Eigen::Vector2d> forces;              ///< in the object frame, if stable
};

/// `tolerance` is the margin below which a sign is taken for 0 when states are enumerated, and
/// GLPK's tolerance of feasibility. O(3^m) programs at worst: for a few contacts.
FloatAnswer decide_in_doubles(const FloatQuestion& question, double tolerance);

}  // namespace stickslip::bench
