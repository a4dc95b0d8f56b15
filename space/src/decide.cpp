// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <utility>

#include "exact_witness.hpp"
#include "spatial_law.hpp"
#include "stickslip/box/box_prover.hpp"
#include "stickslip/space/spatial_verdict.hpp"

namespace stickslip {

using namespace space_detail;

namespace {

constexpr std::size_t kDefaultLimit = 20000;
/// A box that is wide may well be neither, which is to be said soon.
constexpr std::size_t kWideLimit = 1000;
/// Of all trees together, beyond which a box is cut no more.
constexpr std::size_t kMostSearches = 4;

/// The grasp of a box with numbers at these places between their ends, from 0 to 1.
SpatialGrasp grasp_at(SpatialGrasp box, const RationalRow& places) {
  std::size_t next = 0;  // numbers are in the order of their parameters
  for_each_number(box, [&](const std::string& /*place*/, Interval& interval) {
    const Rational& at = places[next++];
    interval = point_interval(interval.low + at * (interval.high - interval.low));
  });
  return box;
}

/// A grasp of the box with all numbers where one would think that it holds better (more
/// friction and preload under less load), or worse.
SpatialGrasp extreme_of(SpatialGrasp box, bool better) {
  for_each_number(box, [&](const std::string& place, Interval& interval) {
    const auto is = [&](const char* name) { return place.find(name) != std::string::npos; };
    std::optional<bool> high;
    if (is("friction") || is("preload")) high = better;
    if (is("wrench")) high = better != (interval.middle().sign() > 0);
    interval = point_interval(!high ? interval.middle() : *high ? interval.high : interval.low);
  });
  return box;
}

/// Two grasps in the box with opposite verdicts.
class ExampleSearch {
 public:
  ExampleSearch(const SpatialQuestion& question, const SpatialSearchOptions& options,
                SearchWork& work)
      : law_(question.law), options_(options), work_(work) {}

  void try_grasp(const SpatialGrasp& grasp) {
    ++work_.examples;
    SpatialOptions as_it_stands;
    as_it_stands.law = law_;
    const SpatialDecision decision = decide(ask(grasp, as_it_stands), options_);
    work_ += decision.work;
    if (const auto stable = throughout(decision)) (*stable ? stable_ : unstable_) = grasp;
  }

  std::optional<Fragile<SpatialGrasp>> found() const {
    if (!stable_ || !unstable_) return std::nullopt;
    return Fragile<SpatialGrasp>{*stable_, *unstable_};
  }

 private:
  NormalLaw law_;
  const SpatialSearchOptions& options_;
  SearchWork& work_;
  std::optional<SpatialGrasp> stable_;
  std::optional<SpatialGrasp> unstable_;
};

}  // namespace

Vector6 motion_of(const StableThroughout& stable) {
  Vector6 motion{};
  std::copy(stable.motion.begin(), stable.motion.end(), motion.begin());
  return motion;
}

SpatialDecision decide(const SpatialQuestion& question, const SpatialSearchOptions& options) {
  SpatialDecision decision{Undecided{}, {}, options.bits};
  const bool is_wide = !question.grasp.is_point();
  const std::size_t limit = options.node_limit != 0 ? options.node_limit
                            : is_wide               ? kWideLimit
                                                    : kDefaultLimit;
  const std::size_t wall_limit = std::max<std::size_t>(limit / (is_wide ? 8 : 24), 1);
  ExampleSearch examples(question, options, decision.work);
  constexpr std::size_t kMostParts = 32;
  for (const std::size_t most_parts : {std::size_t{0}, kMostParts}) {
    BoxProver prover(law_of(question, options.bits),
                     {limit, wall_limit, kMostSearches * limit, most_parts, is_wide},
                     decision.work);
    if (!question.is_box) prover.on_equilibrium(exact_witness);
    if (auto verdict = prover.prove()) {
      std::visit([&](auto& known) { decision.verdict = std::move(known); }, *verdict);
      return decision;
    }
    decision.verdict = undecided_by(prover.report());
    if (!is_wide) break;
    for (const auto& places : prover.suspects()) {
      if (places) examples.try_grasp(grasp_at(question.grasp, *places));
    }
    for (const bool better : {false, true}) {
      if (most_parts == 0 && !examples.found()) {
        examples.try_grasp(extreme_of(question.grasp, better));
      }
    }
    if (auto fragile = examples.found()) {
      decision.verdict = std::move(*fragile);
      return decision;
    }
  }
  return decision;
}

}  // namespace stickslip
