// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The exact half of the search for PCR and PGR: what doubles propose is bounded here in
/// rational numbers. The inequalities are in stickslip/earlier/robustness.hpp.
#pragma once

#include <optional>
#include <vector>

#include "earlier/robustness/force_model.hpp"

namespace stickslip::robustness_detail {

/// A set of states that a contact may have: bit 1 << SpringState for each.
using StateSet = unsigned char;
/// Returns the set of one state.
inline StateSet only(SpringState state) {
  return static_cast<StateSet>(1U << static_cast<unsigned>(state));
}
inline constexpr StateSet kAllStates = 7;

/// A term weight * u u^T of a positive semidefinite matrix, weight >= 0.
struct MatrixTerm {
  double weight;
  Doubles u;
};

/// A twist y and a positive semidefinite matrix Z, rounded from doubles. Z is a sum of squares
/// after rounding, too.
class Multipliers {
 public:
  Multipliers(const Doubles& twist, const std::vector<MatrixTerm>& terms, std::size_t size);

  /// Returns y.a.
  Rational along(const ScaledRow& a) const;
  /// Returns y.a.
  Rational along(const RationalRow& a) const;
  /// Returns a.Z a.
  Rational square(const ScaledRow& a) const;
  const Rational& trace() const { return trace_; }  ///< tr Z
  MixtureLeaf leaf() const;                         ///< y and Z

 private:
  Row twist_;
  Rational twist_unit_;
  std::vector<Row> matrix_;
  Rational matrix_unit_;
  Rational trace_;
};

/// A bound of the values of a set of combinations.
struct NodeBound {
  bool is_empty = false;  ///< whether it is proved that there is none
  /// At least lambda_min of each; nothing if the multipliers bound nothing.
  std::optional<Rational> square{};
};

/// Bounds lambda_min(M(s)) of all combinations s of these sets of states whose best forces have
/// a least distance of at least `distance` >= 0.
NodeBound node_bound(const ForceModel& model, const std::vector<StateSet>& sets,
                     const Rational& distance, const Multipliers& multipliers);

/// Returns max(0, -y.N + mu |y.T|), rounded up, by y.N and y.T: the most work against y of a
/// force in the cone whose normal part is 1. Where there is a pyramid, |y.T| is the largest
/// -y.T along an edge.
Rational most_against(const ForceContact& contact, const Rational& along_normal,
                      const RationalRow& along_tangents);

/// Returns a number that the least distance of no forces in these states exceeds; below 0 if
/// there are none. `twist` is a proposal.
Rational greatest_distance(const ForceModel& model, const std::vector<SpringState>& states,
                           const RationalRow& twist);

/// The best forces whose friction is a sum of given directions.
struct ExactForces {
  Rational distance;            ///< at most each distance of the forces
  std::vector<RationalRow> at;  ///< by ContactId: the normal force, and the tangential ones
  RationalRow twist;            ///< the multipliers y of the balance
};

/// Solves the linear program of these states, with directions for each contact. If no such
/// forces have distances of at least 0, `distance` is -1, and the twist refutes them. Requires
/// that no contact without friction sticks.
ExactForces exact_forces(const ForceModel& model, const std::vector<SpringState>& states,
                         const std::vector<std::vector<FrictionDirection>>& directions);

/// Two numbers between which 1/sigma_max^2 of a combination lies; 0 twice if G has not full
/// rank.
struct InverseSquare {
  Rational low;
  Rational high;
  RationalRow direction;  ///< z, which shows `high` (CombinationLeaf)
};
/// Returns it for these states.
InverseSquare inverse_square(const ForceModel& model, const std::vector<SpringState>& states);

/// Returns whether a symmetric matrix is positive semidefinite.
bool is_positive_semidefinite(std::vector<RationalRow> matrix);

/// Returns a number c >= 0 for which P - c Q is positive semidefinite. `above` >= 0 is a number
/// that none of these exceeds; c is as near to it as a few tries show, and 0 if they show none.
/// P has to be positive semidefinite.
Rational semidefinite_multiple(const std::vector<RationalRow>& p,
                               const std::vector<RationalRow>& q, const Rational& above);

}  // namespace stickslip::robustness_detail
