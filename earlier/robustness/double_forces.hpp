// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The half of the search for PCR and PGR in doubles: it proposes.
#pragma once

#include <optional>
#include <vector>

#include "earlier/robustness/exact_forces.hpp"
#include "earlier/robustness/force_model.hpp"

namespace stickslip::robustness_detail {

/// The directions of friction that programs know, by contact. They grow in space.
class Directions {
 public:
  /// Makes both signs in the plane, and eight directions in space.
  explicit Directions(const ForceModel& model);

  /// Returns the directions of a contact.
  const std::vector<FrictionDirection>& of(std::size_t contact) const { return exact_[contact]; }
  /// Returns the directions of all contacts.
  const std::vector<std::vector<FrictionDirection>>& all() const { return exact_; }
  /// Returns the wrench of the force in this direction whose normal part is 1.
  const std::vector<Doubles>& wrenches(std::size_t contact) const { return wrenches_[contact]; }
  /// Adds the direction in which friction does the most against a twist, if it does much more
  /// than the others there. Returns whether it was added.
  bool add_against(std::size_t contact, const Doubles& twist);

 private:
  void add(std::size_t contact, const FrictionDirection& direction);

  const ForceModel& model_;
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

/// Returns the least eigenvalue of a symmetric matrix of this size, and a unit vector of it.
LeastStiff least_eigenvalue(std::vector<Doubles> matrix, std::size_t size);

/// Returns the largest least distance of forces in these states; nothing if there are none. In
/// space it adds directions.
std::optional<double> propose_distance(const ForceModel& model,
                                       const std::vector<SpringState>& states,
                                       Directions& directions);

/// What a linear program says of a node.
struct NodeProposal {
  bool is_solved = false;
  double square = 0;                         ///< a bound of lambda_min; below 0 if none exists
  Doubles twist{};                           ///< y
  std::vector<MatrixTerm> terms{};           ///< Z
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
