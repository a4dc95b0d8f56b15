// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "examples.hpp"
#include "planar_grasps.hpp"
#include "stickslip/box/box_prover.hpp"
#include "stickslip/degree/prove_stable.hpp"

namespace stickslip {

using namespace box_detail;

namespace {

/// Two grasps in the box with opposite verdicts, if the suspects are right.
std::optional<Fragile<LoadedGrasp>> find_examples(const GraspBox& box, NormalLaw law,
                                                  const Verdict& middle, SearchWork& work) {
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
  return middle_is_stable ? Fragile<LoadedGrasp>{std::move(*same), std::move(*other)}
                          : Fragile<LoadedGrasp>{std::move(*other), std::move(*same)};
}

/// With the lengths enclosed to these bits.
BoxDecision prove_with_bits(const GraspBox& box, NormalLaw law, const BoxOptions& options,
                            std::size_t most_parts, unsigned bits) {
  BoxDecision decision{Undecided{}, {}, bits};
  const std::size_t limit =
      options.node_limit != 0 ? options.node_limit : 500 + 50 * box.contacts.size();
  const std::size_t wall_limit = std::max<std::size_t>(limit / 8, 1);
  BoxProver prover(GraspLaw(box, law, bits),
                   {limit, wall_limit, 8 * limit, most_parts, !box.is_point()}, decision.work);
  if (auto verdict = prover.prove()) {
    std::visit([&](auto& known) { decision.verdict = std::move(known); }, *verdict);
  } else {
    decision.verdict = undecided_by(prover.report());
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

std::optional<bool> is_stable(const LoadedGrasp& loaded, NormalLaw law) {
  const GraspBox box = box_of(loaded);
  if (!needs_enclosure(box)) {
    return std::holds_alternative<Stable>(decide_by_cones(Problem(loaded, law)));
  }
  return throughout(decide_box(box, law));
}

}  // namespace box_detail

std::optional<BoxDecision> prove_stable_by_degree(const Problem& problem) {
  SearchWork work;
  auto proof = prove_by_degree(problem, work);
  if (!proof) return std::nullopt;
  work.parts = 1;
  RationalRow near = proof->twist;
  return BoxDecision{StableThroughout{StabilityProof{std::move(*proof)}, std::move(near)},
                     work};
}

BoxDecision decide_box(const GraspBox& box, NormalLaw law, const BoxOptions& options) {
  BoxDecision decision = prove_box(box, law, options, 0);
  if (box.is_point() || !std::holds_alternative<Undecided>(decision.verdict)) return decision;
  const GraspLaw middle_law = GraspLaw(box, law, options.bits).middle();
  const Verdict middle = decide_by_cones(box_detail::problem_of(middle_law));
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
