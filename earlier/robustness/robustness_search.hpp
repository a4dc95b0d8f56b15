// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The branch and bound that encloses PGR, over states of contacts and the least distance of
/// their forces.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "earlier/robustness/double_forces.hpp"
#include "earlier/robustness/exact_forces.hpp"

namespace stickslip::robustness_detail {

/// The value of one combination of states, enclosed.
struct CombinationValue {
  Rational lower{0};         ///< at most the value
  Rational upper{0};         ///< at least the value
  bool is_possible = false;  ///< whether forces with distances of at least 0 are known
  bool is_refuted = false;   ///< whether it is proved that there are none
  CombinationLeaf leaf{};    ///< shows `upper`, or the refutation
  std::optional<RobustForces> best{};  ///< the forces that show `lower`, if that is not 0
};

/// The best forces of one combination, and how much better none are.
struct BestDistance {
  ExactForces forces;  ///< their distance is below 0 if none are known
  Rational most;       ///< no forces have a larger distance; below 0 if there are none
  RationalRow twist;   ///< shows `most`
};

/// Returns the best forces of one combination. Requires that no contact without friction
/// sticks.
BestDistance best_distance(const ForceModel& model, const std::vector<SpringState>& states);

/// Returns forces as vectors, by contact.
std::vector<RationalRow> forces_on_object(const ForceModel& model, const ExactForces& forces);

/// Returns the combination in which each contact with friction sticks and every other slips.
std::vector<SpringState> first_combination(const ForceModel& model);

/// Encloses the value of one combination. Requires that no contact without friction sticks.
CombinationValue value_of(const ForceModel& model, const std::vector<SpringState>& states);

/// Returns at least the value of a combination, by multipliers in doubles alone, which takes
/// less time.
Rational value_above(const ForceModel& model, const std::vector<SpringState>& states,
                     const Doubles& twist);

/// The search.
class RobustnessSearch {
 public:
  RobustnessSearch(const ForceModel& model, const RobustnessOptions& options);

  /// Encloses PGR. `first` is the combination in which each contact with friction sticks and
  /// every other slips, and `of_first` its value.
  Robustness run(const std::vector<SpringState>& first, CombinationValue of_first);

 private:
  struct Node;
  /// A node of the proof as it grows, a leaf until it has children.
  struct Growing {
    RobustnessNode node;
    std::vector<std::size_t> children{};
  };

  void propose(const std::vector<SpringState>& states);
  void improve();
  void confirm(CombinationValue value);
  bool bound(Node& node);
  std::size_t grow(std::size_t parent);
  std::vector<RobustnessNode> proof() const;
  std::vector<SpringState> rounded(const Node& node) const;

  const ForceModel& model_;
  const RobustnessOptions& options_;
  Directions directions_;
  NodePrograms programs_;
  std::map<std::string, double> known_;  ///< proposed values of combinations
  std::vector<SpringState> proposed_;    ///< the best of them
  double proposed_value_ = 0;
  CombinationValue best_;       ///< the best that is confirmed
  Rational target_;             ///< no combination that was left out is above this
  Rational target_square_;      ///< its square
  double target_double_ = 0;    ///< near it
  Rational leaves_upper_;       ///< at least the values of the combinations that were looked at
  std::vector<Growing> grown_;  ///< the proof, from its root
};

}  // namespace stickslip::robustness_detail
