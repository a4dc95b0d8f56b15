// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The half of the search for PCR and PGR in doubles: it proposes.
#pragma once

#include <optional>
#include <vector>

#include "earlier/robustness/exact_forces.hpp"
#include "earlier/robustness/force_model.hpp"

namespace stickslip::robustness_detail {

/// The directions of friction that programs know, by contact: both signs in the plane; in space
/// those of pyramids, or eight all round, and the latest that were added.
class Directions {
 public:
  /// Knows at most `most` directions of a contact in space, at least nine.
  explicit Directions(const ForceModel& model, std::size_t most);

  /// Returns the directions of a contact.
  const std::vector<FrictionDirection>& of(std::size_t contact) const {
    return exact_[contact];
  }
  /// Returns the wrenches of the forces in these directions whose normal part is 1.
  const std::vector<Doubles>& wrenches(std::size_t contact) const { return wrenches_[contact]; }
  /// Adds the direction in which friction does the most against a twist, if it does more than
  /// the others there. Returns whether it was added; it is the last one then.
  bool add_against(std::size_t contact, const Doubles& twist);

 private:
  void add(std::size_t contact, const FrictionDirection& direction);

  const ForceModel& model_;
  std::size_t most_;
  std::vector<std::vector<FrictionDirection>> exact_;
  std::vector<std::vector<Doubles>> wrenches_;
};

/// The direction in which a grasp is least stiff.
struct LeastStiff {
  double inverse_square = 0;  ///< 1/sigma_max^2, or 0 if G seems not to have full rank
  Doubles direction{};        ///< z of least z.P z / z.Q z (exact_forces.cpp)
};
/// Returns it for a combination of states.
LeastStiff least_stiff(const ForceModel& model, const std::vector<SpringState>& states);

/// Returns a unit vector of the least eigenvalue of M(s).
Doubles least_stretched(const ForceModel& model, const std::vector<SpringState>& states);

/// Returns the least eigenvalue of a symmetric matrix of this size, and a unit vector of it.
LeastStiff least_eigenvalue(std::vector<Doubles> matrix, std::size_t size);

/// Forces in doubles.
struct ForceProposal {
  std::optional<double> distance{};  ///< the largest least distance; nothing if there are none
  Doubles twist{};                   ///< the multipliers y of the balance
  /// The directions that the forces have friction in, by contact.
  std::vector<std::vector<FrictionDirection>> used{};
};

/// Returns the best forces in these states.
ForceProposal propose_forces(const ForceModel& model, const std::vector<SpringState>& states);

/// Returns a twist that all forces in the cones of these states do work along, as far from 0 as
/// may be; nothing if there seems to be none.
std::optional<Doubles> propose_opening(const ForceModel& model,
                                       const std::vector<SpringState>& states);

/// The bound of a linear program for a node.
struct NodeProposal {
  bool is_solved = false;
  double square = 0;                ///< a bound of lambda_min; below 0 if none exists
  Doubles twist{};                  ///< y
  std::vector<MatrixTerm> terms{};  ///< Z
  std::vector<std::array<double, 3>> share{};  ///< by contact, how much of each state
};

/// The linear programs of nodes: they maximise lambda_min over mixtures of states and of forces
/// at a given distance, with lambda_min bounded along some directions, the *cuts*, that are
/// found by and by.
class NodePrograms {
 public:
  NodePrograms(const ForceModel& model, Directions& directions);

  /// Bounds a node. It stops once the bound is at most `enough`. `share` proposes where the
  /// program starts; it may be empty.
  NodeProposal bound(const std::vector<StateSet>& sets, double distance, double enough,
                     const std::vector<std::array<double, 3>>& share);

 private:
  struct Point;
  class Program;

  const ForceModel& model_;
  Directions& directions_;
  std::vector<Doubles> cuts_;
};

}  // namespace stickslip::robustness_detail
