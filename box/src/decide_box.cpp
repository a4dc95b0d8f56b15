// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include "box_search.hpp"
#include "degree.hpp"
#include "stickslip/box/box_verdict.hpp"

namespace stickslip {

using namespace box_detail;

const char* name_of(const BoxVerdict& verdict) {
  constexpr const char* kNames[] = {"stable", "unstable", "fragile", "undecided"};
  return kNames[verdict.index()];
}

namespace {

/// Proofs about a box and its parts, until one fails or two middles disagree.
class Decider {
 public:
  Decider(std::size_t node_limit, std::size_t most_parts, BoxWork& work)
      : node_limit_(node_limit), parts_left_(most_parts), work_(work) {}

  /// Proves what the middle of the box is of all of it; false if that failed, and then
  /// `disagree` says whether two middles differ.
  bool prove(const ParameterBox& box) {
    const Verdict there = decide_by_cones(problem_at(box.middle()));
    const bool stable = std::holds_alternative<Stable>(there);
    if (!first_) first_ = stable;
    if (*first_ != stable) {
      disagree_ = true;
      return false;
    }
    ++work_.parts;
    if (const auto* found = std::get_if<Stable>(&there)) {
      std::vector<Witness> equilibria = find_equilibria(problem_at(box.middle()), 40);
      equilibria.insert(equilibria.begin(), found->witness);
      for (const Witness& equilibrium : equilibria) {
        if (auto proof = prove_stable(box, equilibrium, node_limit_, work_)) {
          parts.push_back(std::move(*proof));
          return true;
        }
      }
    } else {
      const BoxModel model(box);
      BoxSearch search(model, nullptr, node_limit_);
      const std::size_t before = tree.size();
      const bool done = search.refute(BoxRegion::root(model), tree);
      work_.nodes += search.nodes();
      if (done) return true;
      tree.erase(tree.begin() + static_cast<std::ptrdiff_t>(before), tree.end());
    }
    if (parts_left_ == 0) return false;
    --parts_left_;
    const auto split = widest(box, there);
    if (!split) return false;
    parts.push_back(*split);
    tree.push_back(*split);
    const auto [low, high] = box.halves(*split);
    return prove(low) && prove(high);
  }

  bool disagree() const { return disagree_; }
  std::optional<bool> first() const { return first_; }

  StabilityProof parts;
  BoxTrees tree;

 private:
  std::optional<PartSplit> widest(const ParameterBox& box, const Verdict& there) const;

  std::size_t node_limit_;
  std::size_t parts_left_;
  BoxWork& work_;
  std::optional<bool> first_;
  bool disagree_ = false;
};

/// The middle of the interval that matters most: of its contact's force, or of the load.
std::optional<PartSplit> Decider::widest(const ParameterBox& box, const Verdict& there) const {
  const BoxModel model(box);
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
    const ContactNumbers<double>& c = model.contacts[i].rounded;
    const double size = std::hypot(c.normals[0][0], c.normals[0][1]);
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

}  // namespace

BoxDecision decide_box(const GraspBox& box, NormalLaw law, const BoxOptions& options) {
  BoxDecision decision{Undecided{"no proof was found"}, {}, options.bits};
  const ParameterBox parameters(box, law, options.bits);
  const std::size_t limit =
      options.node_limit != 0 ? options.node_limit : 500 + 50 * parameters.size();
  constexpr std::size_t kMostParts = 32;
  Decider decider(limit, kMostParts, decision.work);
  if (decider.prove(parameters)) {
    if (*decider.first()) {
      decision.verdict = StableThroughout{std::move(decider.parts)};
    } else {
      decision.verdict = UnstableThroughout{std::move(decider.tree)};
    }
  }
  return decision;
}

}  // namespace stickslip
