// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "box_prover.hpp"
#include "effort.hpp"
#include "engine/degree/newton.hpp"
#include "engine/degree/prove_stable.hpp"
#include "engine/large/decide_large.hpp"
#include "examples.hpp"
#include "single_grasp.hpp"

namespace stickslip {

using namespace box_detail;

namespace {

/// Searches for two grasps of a box with opposite verdicts, which are decided one by one.
class ExampleSearch {
 public:
  ExampleSearch(const GraspBox& box, NormalLaw law, const SearchOptions& options,
                SearchWork& work)
      : box_(box),
        law_(law),
        options_(options),
        work_(work),
        effort_(effort_for(box)),
        examples_(box, law) {}

  /// Decides this grasp, unless two were found.
  void try_at(const GraspBox& grasp) {
    if (stable_ && unstable_) return;
    ++work_.examples;
    const std::optional<bool> stable = is_stable(grasp, law_, options_);
    if (stable) (*stable ? stable_ : unstable_) = grasp;
  }

  /// Tries the middle, and where the other verdict is likely: where all holds better or worse,
  /// and at the ends of single numbers.
  void try_suspects() {
    try_at(examples_.at(examples_.middle()));
    for (const Place& place : examples_.extremes()) try_at(examples_.at(place));
    if (found() || stable_.has_value() == unstable_.has_value()) return;
    for (const Place& place : examples_.single_ends(effort_.single_ends)) {
      try_at(examples_.at(place));
    }
  }

  /// Tries corners at which Newton's method finds no equilibrium, though it has one of the
  /// middle: this, if it is known.
  void try_lost_corners(std::optional<NearEquilibrium> near) {
    constexpr std::size_t kStarts = 12;
    if (!near) {
      const RoundedGrasp middle = rounded_middle(GraspLaw(box_, law_).middle());
      near = Newton(middle).solve_thoroughly(kStarts);
    }
    if (!near) return;
    constexpr int kMost = 8;
    int tried = 0;
    const auto try_place = [&](const Place& place) {
      if (!stable_) try_at(examples_.at(examples_.middle()));
      if (stable_) try_at(examples_.at(place));
      return stable_ && !unstable_ && ++tried < kMost;
    };
    examples_.visit_weak_corners(*near, try_place);
    tried = 0;
    if (!unstable_) examples_.visit_random_corners(*near, try_place);
  }

  /// Tries the grasp at these parts of the way from low to high of each parameter.
  void try_between(const RationalRow& parts) { try_at(examples_.between(parts)); }

  std::optional<Fragile> found() const {
    if (!stable_ || !unstable_) return std::nullopt;
    return Fragile{*stable_, *unstable_};
  }

 private:
  const GraspBox& box_;
  NormalLaw law_;
  const SearchOptions& options_;
  SearchWork& work_;
  Effort effort_;
  Examples examples_;
  std::optional<GraspBox> stable_;
  std::optional<GraspBox> unstable_;
};

/// Returns the limits of a search for a proof.
ProverLimits limits_of(const GraspBox& box, const SearchOptions& options) {
  const Effort effort = effort_for(box);
  ProverLimits limits{};
  limits.is_wide = !box.is_point();
  limits.rest_first = effort.rest_first;
  limits.node_limit = options.node_limit == 0 ? effort.nodes : options.node_limit;
  limits.wall_limit = std::max<std::size_t>(limits.node_limit / effort.walls, 1);
  limits.most_nodes = effort.trees * limits.node_limit;
  limits.is_default = options.node_limit == 0;
  return limits;
}

/// Returns the limits of a search for a proof that takes little.
ProverLimits quick_limits_of(const GraspBox& box, const SearchOptions& options) {
  ProverLimits limits = limits_of(box, options);
  limits.most_nodes = effort_for(box).quick_nodes;
  limits.node_limit = std::min(limits.node_limit, limits.most_nodes);
  limits.wall_limit = 0;
  limits.is_default = true;
  return limits;
}

/// Sets what a search for a proof has found.
void settle(BoxDecision& decision, std::optional<BoxProver::Verdict> verdict,
            const BoxProver& prover, const GraspBox& box) {
  decision.within.reset();
  if (verdict) {
    std::visit([&](auto& known) { decision.verdict = std::move(known); }, *verdict);
    return;
  }
  Undecided undecided = undecided_by(prover.report());
  if (box.is_point() && needs_enclosure(box) &&
      (undecided.reason == "degree" || undecided.reason == "free")) {
    undecided.remedy =
        "give the preloaded contacts normals of rational length, as stickslip snap does: "
        "then equilibria are found exactly, also where they lie side by side";
  }
  decision.verdict = std::move(undecided);
  if (const auto& tree = prover.near_tree()) decision.within = Unstable{*tree};
}

/// Returns a proof or none, without a search for counterexamples.
BoxDecision prove(const GraspBox& box, NormalLaw law, const SearchOptions& options,
                  const ProverLimits& limits) {
  BoxDecision decision{Undecided{}};
  const Effort effort = effort_for(box);
  const bool may_refine = box.is_point() && effort.may_refine;
  const bool tries_exactly =
      box.is_point() && !needs_enclosure(box) && box.contacts.size() <= effort.exact_contacts;
  for (unsigned bits = options.bits;; bits *= 2) {
    decision.bits = bits;
    BoxProver prover(GraspLaw(box, law, bits), limits, decision.work);
    if (tries_exactly) prover.try_exact_equilibria();
    settle(decision, prover.prove(), prover, box);
    const bool is_open = std::holds_alternative<Undecided>(decision.verdict);
    if (!is_open || !may_refine || 2 * bits > options.most_bits) return decision;
  }
}

}  // namespace

namespace box_detail {

BoxDecision prove_box(const GraspBox& box, NormalLaw law, const SearchOptions& options,
                      std::size_t most_parts) {
  ProverLimits limits = limits_of(box, options);
  limits.most_parts = most_parts;
  return prove(box, law, options, limits);
}

}  // namespace box_detail

WrenchBox loads_of(const GraspBox& box) {
  WrenchBox loads = box.wrench;
  if (!box.ball) return loads;
  const BallPart ball = BallPart::all_of(box);
  for (std::size_t j = 0; j < loads.size(); ++j) {
    Row along(loads.size());
    along[j] = 1;
    loads[j].low -= ball.most_work(negated(along));
    loads[j].high += ball.most_work(along);
  }
  return loads;
}

std::optional<BoxDecision> prove_stable_by_degree(const Problem& problem) {
  SearchWork work;
  auto proof = prove_by_degree(problem, work);
  if (!proof) return std::nullopt;
  work.parts = 1;
  RationalRow near = proof->twist;
  return BoxDecision{Stable{StabilityProof{std::move(*proof)}, std::move(near)}, work};
}

BoxDecision decide_box(const GraspBox& box, NormalLaw law, const SearchOptions& options) {
  if (box.is_point()) {
    return is_large(box) ? decide_large(box, law) : prove_box(box, law, options, 0);
  }
  SearchWork work;
  ExampleSearch examples(box, law, options, work);
  const GraspLaw box_law(box, law, options.bits);
  const bool is_quick_first = effort_for(box).quick_nodes > 0;
  if (is_quick_first) {
    // Proofs that take long are sought only where no counterexample lies at hand.
    BoxDecision quick{Undecided{}};
    quick.bits = options.bits;
    BoxProver prover(box_law, quick_limits_of(box, options), quick.work);
    settle(quick, prover.prove(), prover, box);
    if (!std::holds_alternative<Undecided>(quick.verdict)) return quick;
    work += quick.work;
    examples.try_lost_corners(prover.middle());
    if (auto fragile = examples.found()) return {std::move(*fragile), work};
  }
  BoxDecision decision{Undecided{}};
  decision.bits = options.bits;
  ProverLimits limits = limits_of(box, options);
  limits.examples_next = true;
  BoxProver prover(box_law, limits, decision.work);
  settle(decision, prover.prove(), prover, box);
  // Neither examples nor parts say more where only far motions are left.
  const auto is_open = [&] {
    return std::holds_alternative<Undecided>(decision.verdict) && !decision.within;
  };
  const auto try_parts = [&] {
    for (const auto& parts : prover.suspects()) {
      if (parts) examples.try_between(*parts);
    }
    if (auto fragile = examples.found()) decision.verdict = std::move(*fragile);
  };
  if (is_open()) {
    examples.try_suspects();
    if (!examples.found() && !is_quick_first) examples.try_lost_corners(prover.middle());
    try_parts();
  }
  if (is_open()) {
    constexpr std::size_t kMostParts = 32;
    settle(decision, prover.prove_in_parts(kMostParts), prover, box);
    if (is_open()) try_parts();
  }
  decision.work += work;
  return decision;
}

}  // namespace stickslip
