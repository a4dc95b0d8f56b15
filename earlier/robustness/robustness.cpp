// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/robustness.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "earlier/robustness/robustness_search.hpp"
#include "stickslip/arrangement/faces.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip {

using namespace robustness_detail;

namespace {

/// Returns an answer without a search, if there is one: G has not full rank, or forces do not
/// balance the load, or have no distance above 0 where each contact with friction sticks and
/// every other slips. No combination is better then, because the forces of another one, and
/// small internal forces where it detaches contacts, would be better there, too.
std::optional<Robustness> known_answer(const ForceModel& model,
                                       const std::vector<SpringState>& first,
                                       const CombinationValue& value) {
  Robustness result;
  const CombinationLeaf& leaf = value.leaf;
  const std::size_t n = model.coordinates;
  if (rank_of(model.columns(first)) < n) {
    result.has_full_rank = false;
    std::vector<RationalRow> square(n, RationalRow(n));
    for (std::size_t j = 0; j < n; ++j) {
      add_multiple(square[j], leaf.direction[j], leaf.direction);
    }
    result.proof = {MixtureLeaf{RationalRow(n), std::move(square)}};
    return result;
  }
  if (value.is_refuted) {
    result.balances = false;
    result.proof = {MixtureLeaf{leaf.twist, std::vector<RationalRow>(n, RationalRow(n))}};
    return result;
  }
  if (!value.upper.is_zero()) return std::nullopt;
  result.proof = {NoDistanceLeaf{leaf.twist}};
  return result;
}

/// Returns the combinations of states of all motions in the plane: one for each face of the
/// arrangement of the planes N.y = 0 and T.y = 0, of which there are O(m^2).
std::set<std::vector<SpringState>> states_of_motions(const ForceModel& model) {
  const std::size_t m = model.contacts.size();
  std::vector<FacePlane> planes;  // those of N, then those of T
  for (const ForceContact& contact : model.contacts) planes.push_back({contact.normal.integers});
  for (const ForceContact& contact : model.contacts) {
    planes.push_back({contact.tangents.front().integers});
  }
  std::set<std::vector<SpringState>> found;
  visit_faces(model.coordinates, planes, [&](const Face& face) {
    std::vector<SpringState> states;
    for (std::size_t i = 0; i < m; ++i) {
      states.push_back(face.sign(i) == Sign::kPositive   ? SpringState::kDetached
                       : face.sign(m + i) == Sign::kZero ? SpringState::kStick
                                                         : SpringState::kSlip);
    }
    found.insert(std::move(states));
    return true;
  });
  return found;
}

}  // namespace

Robustness potential_contact_robustness(const GraspBox& grasp,
                                        const RobustnessOptions& options) {
  const ForceModel model(grasp, options);
  const std::vector<SpringState> first = first_combination(model);
  CombinationValue value = value_of(model, first);
  auto known = known_answer(model, first, value);
  Robustness result = known ? std::move(*known) : Robustness();
  // One leaf is enough, even where a contact without friction has no state.
  result.proof = {value.leaf};
  if (known) return result;
  // A contact without friction has no distance above 0 where it sticks.
  if (std::find(first.begin(), first.end(), SpringState::kSlip) != first.end()) return result;
  result.lower = value.lower;
  result.upper = value.upper;
  result.best = std::move(value.best);
  result.is_complete = result.upper <= (1 + options.accuracy) * result.lower;
  return result;
}

Robustness potential_grasp_robustness(const GraspBox& grasp, const RobustnessOptions& options) {
  const ForceModel model(grasp, options);
  const std::vector<SpringState> first = first_combination(model);
  CombinationValue value = value_of(model, first);
  if (const auto known = known_answer(model, first, value)) return *known;
  return RobustnessSearch(model, options).run(first, std::move(value));
}

Robustness potential_robustness(RobustnessKind kind, const GraspBox& grasp,
                                const RobustnessOptions& options) {
  return kind == RobustnessKind::kContact ? potential_contact_robustness(grasp, options)
                                          : potential_grasp_robustness(grasp, options);
}

Robustness rigid_motion_robustness(const GraspBox& grasp, const RobustnessOptions& options) {
  require(!grasp.in_space(), "rigid motions are enumerated in the plane only");
  const ForceModel model(grasp, options);
  const std::vector<SpringState> first = first_combination(model);
  if (auto known = known_answer(model, first, value_of(model, first))) return *known;
  Robustness result;
  for (const std::vector<SpringState>& states : states_of_motions(model)) {
    bool is_zero = false;
    for (std::size_t i = 0; i < states.size(); ++i) {
      is_zero = is_zero || (states[i] == SpringState::kStick && !model.contacts[i].can_stick());
    }
    if (is_zero || rank_of(model.columns(states)) < model.coordinates) continue;
    ++result.nodes;
    // Most combinations are below the best one, which a bound shows.
    const ForceProposal proposal = propose_forces(model, states);
    const Rational above = value_above(model, states, proposal.twist);
    if (above <= result.lower) continue;
    CombinationValue value = value_of(model, states);
    result.upper = std::max(result.upper, std::min(value.upper, above));
    if (value.lower <= result.lower) continue;
    result.lower = value.lower;
    result.best = std::move(value.best);
  }
  result.upper = std::max(result.upper, result.lower);
  result.is_complete = result.upper <= (1 + options.accuracy) * result.lower;
  return result;
}

}  // namespace stickslip
