// SPDX-License-Identifier: GPL-3.0-or-later
#include "earlier/robustness/robustness_search.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>
#include <utility>

#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip::robustness_detail {
namespace {

constexpr unsigned kValueBits = 60;
constexpr unsigned kShortBits = 32;
constexpr std::array<SpringState, 3> kStates{SpringState::kStick, SpringState::kSlip,
                                             SpringState::kDetached};
/// The directions of a contact in the programs of nodes, in space.
constexpr std::size_t kSearchDirections = 20;
/// The part by which exact forces may be worse than those in doubles.
constexpr double kFarOff = 1e-5;
/// How often the lower end of a node's distances is raised.
constexpr int kMostRaises = 12;

std::string word_of(const std::vector<SpringState>& states) {
  std::string word;
  for (const SpringState state : states)
    word += static_cast<char>('0' + static_cast<int>(state));
  return word;
}

bool is_single(StateSet set) {
  return (set & (set - 1)) == 0;
}

/// Returns a number near `value` >= 0 that is at least that, of few bits unless that is tiny.
Rational rounded_up(const Rational& value) {
  const Rational above = rational_in_bits(to_double(value) * (1 + 0x1p-42), 46);
  return above >= value ? above : value;
}

/// Returns such a number that is at most `value`.
Rational rounded_down(const Rational& value) {
  const Rational below = rational_in_bits(to_double(value) * (1 - 0x1p-42), 46);
  return below <= value ? below : value;
}

}  // namespace

std::vector<SpringState> first_combination(const ForceModel& model) {
  std::vector<SpringState> first;
  for (const ForceContact& contact : model.contacts) {
    first.push_back(contact.can_stick() ? SpringState::kStick : SpringState::kSlip);
  }
  return first;
}

BestDistance best_distance(const ForceModel& model, const std::vector<SpringState>& states) {
  const ForceProposal proposal = propose_forces(model, states);
  // In the plane all of friction has two directions, in space those that doubles use will do.
  Directions directions(model, kSearchDirections);
  std::vector<std::vector<FrictionDirection>> all;
  for (std::size_t i = 0; i < states.size(); ++i) all.push_back(directions.of(i));
  const bool has_proposal = model.coordinates == 6 && proposal.distance;
  ExactForces forces = exact_forces(model, states, has_proposal ? proposal.used : all);
  if (has_proposal && (forces.distance.sign() <= 0 ||
                       to_double(forces.distance) < *proposal.distance * (1 - kFarOff))) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      all[i].insert(all[i].end(), proposal.used[i].begin(), proposal.used[i].end());
    }
    forces = exact_forces(model, states, all);
  }
  BestDistance result{std::move(forces), 0, {}};
  result.twist = result.forces.twist;
  result.most = greatest_distance(model, states, result.twist);
  const auto try_twist = [&](const Doubles& twist) {
    RationalRow rounded;
    for (std::size_t j = 0; j < model.coordinates; ++j) {
      rounded.push_back(rational_in_bits(twist[j], 40));
    }
    Rational distance = greatest_distance(model, states, rounded);
    if (distance >= result.most) return;
    result.most = std::move(distance);
    result.twist = std::move(rounded);
  };
  if (model.coordinates == 6) {
    try_twist(proposal.twist);
    if (result.forces.distance.sign() == 0) {
      if (const auto twist = propose_opening(model, states)) try_twist(*twist);
    }
  }
  return result;
}

std::vector<RationalRow> forces_on_object(const ForceModel& model, const ExactForces& forces) {
  std::vector<RationalRow> result;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const ForceContact& contact = model.contacts[i];
    RationalRow& force = result.emplace_back(contact.n.size());
    add_multiple(force, forces.at[i][0], contact.n);
    for (std::size_t k = 0; k < contact.t.size(); ++k) {
      add_multiple(force, forces.at[i][k + 1], contact.t[k]);
    }
  }
  return result;
}

CombinationValue value_of(const ForceModel& model, const std::vector<SpringState>& states) {
  CombinationValue result;
  const auto [low, high, direction] = inverse_square(model, states);
  const BestDistance found = best_distance(model, states);
  const Rational& distance = found.forces.distance;
  result.leaf.direction = direction;
  result.leaf.twist = found.twist;
  result.is_refuted = found.most.sign() < 0;
  result.is_possible = distance.sign() >= 0;
  if (found.most.sign() > 0) {
    result.upper = short_sqrt(found.most * found.most * high, kValueBits).upper;
  }
  if (distance.sign() <= 0 || low.is_zero()) return result;
  result.lower = short_sqrt(distance * distance * low, kValueBits).lower;
  result.best = RobustForces{states, forces_on_object(model, found.forces), distance, low};
  return result;
}

Rational value_above(const ForceModel& model, const std::vector<SpringState>& states,
                     const Doubles& twist) {
  RationalRow rounded;
  for (std::size_t j = 0; j < model.coordinates; ++j) {
    rounded.push_back(rational_in_bits(twist[j], 40));
  }
  const Rational most = greatest_distance(model, states, rounded);
  if (most.sign() <= 0) return 0;
  return short_sqrt(most * most * inverse_square(model, states).high, kShortBits).upper;
}

/// A set of combinations whose least distance is from `low` to `high`.
struct RobustnessSearch::Node {
  std::vector<StateSet> sets;
  Rational low;
  Rational high;
  Rational upper;                            ///< no value in the node is above
  std::shared_ptr<const Multipliers> shown;  ///< what shows `upper`
  std::size_t place = 0;                     ///< that of the node in the proof
  std::vector<std::array<double, 3>> share{};
  std::size_t depth = 0;

  /// Orders nodes by their bounds, and equal ones by their depth.
  friend bool operator<(const Node& a, const Node& b) {
    return a.upper < b.upper || (a.upper == b.upper && a.depth < b.depth);
  }
};

RobustnessSearch::RobustnessSearch(const ForceModel& model, const RobustnessOptions& options)
    : model_(model),
      options_(options),
      directions_(model, kSearchDirections),
      programs_(model, directions_) {}

/// Takes a combination for the best one if doubles say so.
void RobustnessSearch::propose(const std::vector<SpringState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] == SpringState::kStick && !model_.contacts[i].can_stick()) return;
  }
  const auto [place, is_new] = known_.emplace(word_of(states), 0);
  if (!is_new) return;
  const double stiff = std::sqrt(least_stiff(model_, states).inverse_square);
  // No distance is above f / 2.
  if (stiff * model_.most_force_double / 2 <= proposed_value_) return;
  const std::optional<double> distance = propose_forces(model_, states).distance;
  if (!distance) return;
  place->second = *distance * stiff;
  if (place->second <= proposed_value_ * (1 + 1e-9)) return;
  proposed_value_ = place->second;
  proposed_ = states;
}

/// Changes the state of one contact after another while that helps.
void RobustnessSearch::improve() {
  constexpr int kMostRounds = 3;
  for (int round = 0; round < kMostRounds; ++round) {
    const double before = proposed_value_;
    for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
      for (const SpringState state : kStates) {
        std::vector<SpringState> states = proposed_;
        if (states[i] == state) continue;
        states[i] = state;
        propose(states);
      }
    }
    if (proposed_value_ <= before) return;
  }
}

/// Takes the exact value of the proposal, and raises the target.
void RobustnessSearch::confirm(CombinationValue value) {
  leaves_upper_ = std::max(leaves_upper_, value.upper);
  if (value.lower > best_.lower) {
    best_ = std::move(value);
    target_ = rounded_down((1 + options_.accuracy) * best_.lower);
    target_square_ = target_ * target_;
    target_double_ = to_double(target_);
  }
  proposed_value_ = to_double(best_.lower);
  if (best_.best) proposed_ = best_.best->states;
}

/// Adds a child to a node of the proof. Returns its place.
std::size_t RobustnessSearch::grow(std::size_t parent) {
  grown_.push_back({});
  grown_[parent].children.push_back(grown_.size() - 1);
  return grown_.size() - 1;
}

/// Returns the nodes of the proof in preorder.
std::vector<RobustnessNode> RobustnessSearch::proof() const {
  std::vector<RobustnessNode> result;
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    const Growing& next = grown_[open.back()];
    open.pop_back();
    result.push_back(next.node);
    open.insert(open.end(), next.children.rbegin(), next.children.rend());
  }
  return result;
}

/// Bounds a node, and raises the lower end of its distances while that helps. Returns true if
/// nothing in it is above the target; it is a leaf of the proof then.
bool RobustnessSearch::bound(Node& node) {
  for (int raise = 0; raise < kMostRaises; ++raise) {
    const double high = to_double(node.high);
    const double root = target_double_ / high;
    const NodeProposal found =
        programs_.bound(node.sets, to_double(node.low), root * root * (1 - 1e-8), node.share);
    if (!found.is_solved) return false;
    if (!found.share.empty()) node.share = found.share;
    const auto tried =
        std::make_shared<const Multipliers>(found.twist, found.terms, model_.coordinates);
    const NodeBound exact = node_bound(model_, node.sets, node.low, *tried);
    const auto is_leaf = [&] {
      grown_[node.place].node = node.shown->leaf();
      return true;
    };
    if (exact.is_empty) {
      node.shown = tried;
      return is_leaf();
    }
    if (!exact.square) return false;
    const Rational square = rounded_up(*exact.square);
    Rational upper = rounded_up(short_sqrt(node.high * node.high * square, kShortBits).upper);
    if (upper < node.upper) {
      node.upper = std::move(upper);
      node.shown = tried;
    }
    if (node.upper <= target_) return is_leaf();
    // Nothing with distances up to this one is above the target.
    const Rational low = rational_in_bits(
        to_double(short_sqrt(target_square_ / square, kShortBits).lower) * (1 - 0x1p-30), 34);
    if (low * low * square > target_square_) return false;
    if (low >= node.high) {
      node.shown = tried;
      return is_leaf();
    }
    if (low <= node.low) return false;
    const bool helps = low > node.low * Rational(1001, 1000);
    node.low = low;
    grown_[node.place].node = DistanceSplit{low};
    const std::size_t below = grow(node.place);
    grown_[below].node = tried->leaf();
    node.place = grow(node.place);
    if (!helps) return false;
  }
  return false;
}

std::vector<SpringState> RobustnessSearch::rounded(const Node& node) const {
  std::vector<SpringState> states;
  for (std::size_t i = 0; i < node.sets.size(); ++i) {
    std::optional<SpringState> most;
    for (const SpringState state : kStates) {
      if ((node.sets[i] & only(state)) == 0) continue;
      if (state == SpringState::kStick && !model_.contacts[i].can_stick()) continue;
      if (!most ||
          (!node.share.empty() && node.share[i][static_cast<std::size_t>(state)] >
                                      node.share[i][static_cast<std::size_t>(*most)])) {
        most = state;
      }
    }
    states.push_back(most.value_or(SpringState::kDetached));
  }
  return states;
}

Robustness RobustnessSearch::run(const std::vector<SpringState>& first,
                                 CombinationValue of_first) {
  Robustness result;
  proposed_ = first;
  proposed_value_ = 0;
  confirm(std::move(of_first));
  Node root{std::vector<StateSet>(first.size(), kAllStates), 0, model_.most_force / 2, 0, {}};
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (!model_.contacts[i].can_stick()) root.sets[i] &= static_cast<StateSet>(~1U);
  }
  // No combination has a larger lambda_min than the first one.
  root.shown = std::make_shared<const Multipliers>(
      Doubles{}, std::vector<MatrixTerm>{{1, least_stretched(model_, first)}},
      model_.coordinates);
  root.upper = rounded_up(
      short_sqrt(root.high * root.high *
                     node_bound(model_, root.sets, root.low, *root.shown).square.value(),
                 kShortBits)
          .upper);
  grown_ = {{root.shown->leaf()}};
  if (best_.lower.is_zero()) {
    // Only in space, where the cones are round, may it be unknown whether that is the value.
    result.upper = root.upper;
    result.proof = proof();
    result.is_complete = false;
    return result;
  }
  improve();
  confirm(value_of(model_, proposed_));
  std::priority_queue<Node> open;
  open.push(std::move(root));
  while (!open.empty() && open.top().upper > target_ && result.nodes < options_.node_limit) {
    throw_if_cancelled();
    Node node = open.top();
    open.pop();
    ++result.nodes;
    if (bound(node)) continue;
    const bool is_leaf = std::all_of(node.sets.begin(), node.sets.end(), is_single);
    const double before = proposed_value_;
    propose(rounded(node));
    if (proposed_value_ > before) {
      improve();
      confirm(value_of(model_, proposed_));
    }
    if (is_leaf) {
      CombinationValue value = value_of(model_, rounded(node));
      leaves_upper_ = std::max(leaves_upper_, value.upper);
      grown_[node.place].node = value.leaf;
      if (value.lower > best_.lower) {
        proposed_ = rounded(node);
        confirm(std::move(value));
      }
      continue;
    }
    // The contact to split is the one that is farthest from one state.
    std::size_t split = 0;
    double least = 2;
    for (std::size_t i = 0; i < node.sets.size(); ++i) {
      if (is_single(node.sets[i])) continue;
      const double most = node.share.empty()
                              ? 0
                              : *std::max_element(node.share[i].begin(), node.share[i].end());
      if (most < least) {
        least = most;
        split = i;
      }
    }
    const Rational widest = least > 0.999 ? Rational(51, 50) : Rational(21, 20);
    ++node.depth;
    if (node.high > widest * node.low) {
      const Rational middle = rational_in_bits(
          node.low.is_zero() ? to_double(node.high) / 2
                             : std::sqrt(to_double(node.low) * to_double(node.high)),
          30);
      Node lower = node;
      lower.high = middle;
      lower.upper = rounded_up(node.upper * middle / node.high);
      node.low = middle;
      grown_[node.place].node = DistanceSplit{middle};
      lower.place = grow(node.place);
      node.place = grow(node.place);
      open.push(std::move(lower));
      open.push(std::move(node));
      continue;
    }
    grown_[node.place].node = StateSplit{split};
    for (const SpringState state : kStates) {
      if ((node.sets[split] & only(state)) == 0) continue;
      Node child = node;
      child.place = grow(node.place);
      child.sets[split] = only(state);
      open.push(std::move(child));
    }
  }
  result.lower = best_.lower;
  result.best = best_.best;
  result.upper = std::max(target_, leaves_upper_);
  if (!open.empty()) result.upper = std::max(result.upper, open.top().upper);
  for (; !open.empty(); open.pop()) grown_[open.top().place].node = open.top().shown->leaf();
  result.proof = proof();
  result.is_complete = result.upper <= (1 + options_.accuracy) * result.lower;
  return result;
}

}  // namespace stickslip::robustness_detail
