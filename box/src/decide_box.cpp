// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "box_law.hpp"
#include "degree.hpp"
#include "examples.hpp"
#include "prove.hpp"
#include "stickslip/box/box_verdict.hpp"
#include "stickslip/equilibrium/stable_by_degree.hpp"
#include "stickslip/search/force_span.hpp"
#include "stickslip/search/tree_search.hpp"

namespace stickslip {

using namespace box_detail;

const char* name_of(const BoxVerdict& verdict) {
  constexpr const char* kNames[] = {"stable", "unstable", "fragile", "undecided"};
  return kNames[verdict.index()];
}

namespace {

/// Of each tree search.
std::size_t node_limit(const ParameterBox& box, const BoxOptions& options) {
  return options.node_limit != 0 ? options.node_limit : 500 + 50 * box.size();
}

/// Of one of the twelve trees of a part.
std::size_t wall_limit(std::size_t node_limit) {
  return std::max<std::size_t>(node_limit / 8, 1);
}

/// Proofs about a box and its parts, until one fails or two middles differ.
class Decider {
 public:
  /// `is_one_grasp`: all that is uncertain are roots.
  Decider(std::size_t node_limit, std::size_t most_parts, bool is_one_grasp, SearchWork& work)
      : is_one_grasp_(is_one_grasp),
        node_limit_(node_limit),
        wall_limit_(wall_limit(node_limit)),
        parts_left_(most_parts),
        most_nodes_(kMostSearches * node_limit),
        work_(work) {}

  /// Proves what the middle of the box is of all of it; false if that failed.
  bool prove(const ParameterBox& box) {
    const Problem middle = problem_at(box.middle());
    // Roots are enclosed in so many bits that an exact equilibrium takes longer than a proof.
    if (is_one_grasp_ || has_long_equilibria(middle)) {
      const std::size_t before = work_.nodes;
      if (const auto stable = prove_without_middle(box)) {
        if (!first_) first_ = stable;
        ++work_.parts;
        return *first_ == *stable;
      }
      most_nodes_ += work_.nodes - before;  // what follows may take as much as ever
    }
    const Verdict there = decide_by_cones(middle);
    const bool stable = std::holds_alternative<Stable>(there);
    if (!first_) first_ = stable;
    if (*first_ != stable) return false;
    ++work_.parts;
    if (const auto* found = std::get_if<Stable>(&there)) {
      std::vector<Witness> equilibria = find_equilibria(middle, 40);
      equilibria.insert(equilibria.begin(), found->witness);
      constexpr std::size_t kMostTried = 4;
      equilibria.resize(std::min(equilibria.size(), kMostTried));
      for (const Witness& equilibrium : equilibria) {
        const RoundedEquilibrium near = rounded_equilibrium(middle, equilibrium);
        if (auto proof = prove_stable(box, near, wall_limit_, work_)) {
          parts.push_back(std::move(*proof));
          return true;
        }
      }
    } else if (refute(box)) {
      return true;
    }
    if (parts_left_ == 0 || is_spent()) return false;
    --parts_left_;
    const auto split = widest(box, there);
    if (!split) return false;
    parts.push_back(*split);
    tree.push_back(*split);
    const auto [low, high] = box.halves(*split);
    return prove(low) && prove(high);
  }

  std::optional<bool> first() const { return first_; }
  /// \{ Of the last tree for all motions, and of all.
  SearchEnd end() const { return end_; }
  bool is_spent() const { return work_.nodes > most_nodes_; }
  /// \}

  StabilityProof parts;
  Trees tree;

 private:
  bool refute(const ParameterBox& box) {
    const Law model = law_of(box);
    if (const std::optional<Row> y = unopposed_twist(model)) {
      tree.emplace_back(TwistLeaf{*y});
      ++work_.nodes;
      ++work_.leaves;
      return true;
    }
    TreeSearch search(model, nullptr, node_limit_, work_);
    const std::size_t before = tree.size();
    const bool done = search.refute(MotionRegion::root(model), tree);
    end_ = search.end();
    if (!done) tree.erase(tree.begin() + static_cast<std::ptrdiff_t>(before), tree.end());
    return done;
  }

  /// What the box is, without an exact verdict about its middle; nothing if that failed.
  std::optional<bool> prove_without_middle(const ParameterBox& box) {
    if (auto proof = prove_stable_by_degree(box, wall_limit_, work_)) {
      parts.push_back(std::move(*proof));
      return true;
    }
    if (refute(box)) return false;
    return std::nullopt;
  }

  std::optional<PartSplit> widest(const ParameterBox& box, const Verdict& there) const;

  bool is_one_grasp_;
  std::size_t node_limit_;
  std::size_t wall_limit_;
  std::size_t parts_left_;
  /// Of all trees together, beyond which the box is cut no more: failures must be quick, too.
  static constexpr std::size_t kMostSearches = 8;
  std::size_t most_nodes_;
  SearchWork& work_;
  std::optional<bool> first_;
  SearchEnd end_ = SearchEnd::kNone;
};

/// The middle of the interval that matters most: of its contact's force, or of the load.
std::optional<PartSplit> Decider::widest(const ParameterBox& box, const Verdict& there) const {
  const Law model = law_of(box);
  std::optional<PartSplit> best;
  double most = 0;
  const auto consider = [&](Parameter parameter, std::size_t index, double effect) {
    const Interval& interval = box.interval(parameter, index);
    if (interval.is_point() || !(effect > most)) return;
    most = effect;
    best = PartSplit{parameter, index, interval.middle()};
  };
  const auto half = [&](Parameter parameter, std::size_t index) {
    const Interval& interval = box.interval(parameter, index);
    return to_double(interval.high - interval.low) / 2;
  };
  const auto* stable = std::get_if<Stable>(&there);
  for (std::size_t i = 0; i < box.size(); ++i) {
    const LawContact& c = model.contacts[i];
    const double size = c.corners.front().normal_rounded.head<2>().norm();
    const double a = stable != nullptr ? to_double(stable->witness.forces[i].normal)
                                       : (c.preloads[0] + c.preloads[1]) / 2;
    consider(Parameter::kFriction, i, a * size * half(Parameter::kFriction, i));
    consider(Parameter::kPreload, i, a > 0 ? size * half(Parameter::kPreload, i) : 0);
    const double stretch = std::fabs(a - (c.preloads[0] + c.preloads[1]) / 2);
    consider(Parameter::kStiffness, i,
             stretch * size * half(Parameter::kStiffness, i) /
                 ((c.stiffnesses[0] + c.stiffnesses[1]) / 2));
    consider(Parameter::kX, i, a * size * half(Parameter::kX, i) / model.length);
    consider(Parameter::kY, i, a * size * half(Parameter::kY, i) / model.length);
    consider(Parameter::kTurn, i, a * size * half(Parameter::kTurn, i));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    consider(Parameter::kWrench, j, half(Parameter::kWrench, j) / (j == 2 ? model.length : 1));
  }
  return best;
}

/// Two grasps in the box with opposite verdicts, if the suspects are right.
std::optional<Fragile> find_examples(const GraspBox& box, NormalLaw law, const Verdict& middle,
                                     SearchWork& work) {
  const auto* equilibrium = std::get_if<Stable>(&middle);
  const bool middle_is_stable = equilibrium != nullptr;
  const Examples examples(box, law);
  std::optional<LoadedGrasp> same;
  std::optional<LoadedGrasp> other;
  const auto look = [&](const Place& place) {
    ++work.examples;
    LoadedGrasp grasp = examples.at(place);
    const std::optional<bool> stable = is_stable(grasp, law);
    if (stable) (*stable == middle_is_stable ? same : other) = std::move(grasp);
  };
  if (equilibrium != nullptr) {
    constexpr std::size_t kMostTried = 8;
    std::size_t tried = 0;
    for (const auto& [place, part] : examples.without(equilibrium->witness)) {
      if (!other && tried++ < kMostTried) look(place);
    }
  }
  for (const Place& place : examples.extremes()) {
    if (!other) look(place);
  }
  if (!other) {
    for (const Place& place : examples.suspects(middle_is_stable)) {
      if (!other) look(place);
    }
  }
  if (!other) return std::nullopt;
  look(examples.middle());
  if (!same) return std::nullopt;
  return middle_is_stable ? Fragile{std::move(*same), std::move(*other)}
                          : Fragile{std::move(*other), std::move(*same)};
}

/// With the lengths enclosed to these bits.
BoxDecision prove_with_bits(const GraspBox& box, NormalLaw law, const BoxOptions& options,
                            std::size_t most_parts, unsigned bits) {
  BoxDecision decision{Undecided{}, {}, bits};
  const ParameterBox parameters(box, law, bits);
  const std::size_t limit = node_limit(parameters, options);
  Decider decider(limit, most_parts, box.is_point(), decision.work);
  if (!decider.prove(parameters)) {
    decision.verdict =
        undecided_by({decider.end(), limit, decider.is_spent(), !box.is_point(), {}});
  } else if (*decider.first()) {
    decision.verdict = StableThroughout{std::move(decider.parts)};
  } else {
    decision.verdict = UnstableThroughout{std::move(decider.tree)};
  }
  return decision;
}

}  // namespace

namespace box_detail {

BoxDecision prove_box(const GraspBox& box, NormalLaw law, const BoxOptions& options,
                      std::size_t most_parts) {
  SearchWork work;
  for (unsigned bits = options.bits;; bits *= 2) {
    BoxDecision decision = prove_with_bits(box, law, options, most_parts, bits);
    work += decision.work;
    decision.work = work;
    const bool finer_may_help = std::holds_alternative<Undecided>(decision.verdict) &&
                                box.is_point() && 2 * bits <= options.most_bits;
    if (!finer_may_help) return decision;
  }
}

std::optional<bool> throughout(const BoxDecision& decision) {
  if (std::holds_alternative<StableThroughout>(decision.verdict)) return true;
  if (std::holds_alternative<UnstableThroughout>(decision.verdict)) return false;
  return std::nullopt;
}

std::optional<bool> is_stable(const LoadedGrasp& loaded, NormalLaw law) {
  const GraspBox box = box_of(loaded);
  if (!needs_enclosure(box)) {
    return std::holds_alternative<Stable>(decide_by_cones(Problem(loaded, law)));
  }
  return throughout(decide_box(box, law));
}

}  // namespace box_detail

namespace {

TreeNode in_any_dimension(const RefutationNode& node) {
  struct Convert {
    TreeNode operator()(const SlipSplit& split) const { return split; }
    TreeNode operator()(const SeparationSplit& split) const { return split; }
    TreeNode operator()(const PlaneSplit& split) const {
      return PlaneCut{{split.plane.begin(), split.plane.end()}};
    }
    TreeNode operator()(const VirtualWorkLeaf& leaf) const {
      return TwistLeaf{{leaf.twist.begin(), leaf.twist.end()}};
    }
  };
  return std::visit(Convert{}, node);
}

}  // namespace

std::optional<BoxDecision> prove_stable_by_degree(const Problem& problem) {
  DegreeWork work;
  const std::optional<ProofByDegree> found = prove_by_degree(problem, &work);
  if (!found) return std::nullopt;
  DegreeProof proof{*found, found->direction, {}};
  for (const RefutationNode& node : found->trees) {
    proof.trees.push_back(in_any_dimension(node));
  }
  BoxDecision decision{StableThroughout{{std::move(proof)}}, {}};
  decision.work.nodes = work.cone.nodes;
  decision.work.proofs = work.proofs;
  decision.work.parts = 1;
  return decision;
}

BoxDecision decide_box(const GraspBox& box, NormalLaw law, const BoxOptions& options) {
  BoxDecision decision = prove_box(box, law, options, 0);
  if (box.is_point() || !std::holds_alternative<Undecided>(decision.verdict)) return decision;
  const ParameterBox parameters(box, law, options.bits);
  const Verdict middle = decide_by_cones(problem_at(parameters.middle()));
  if (auto fragile = find_examples(box, law, middle, decision.work)) {
    decision.verdict = std::move(*fragile);
    return decision;
  }
  constexpr std::size_t kMostParts = 32;
  BoxDecision pieces = prove_box(box, law, options, kMostParts);
  pieces.work += decision.work;
  return pieces;
}

}  // namespace stickslip
