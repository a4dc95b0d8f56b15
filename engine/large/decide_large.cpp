// SPDX-License-Identifier: GPL-3.0-or-later
#include "decide_large.hpp"

#include <utility>

#include "engine/statics/statics_search.hpp"
#include "sparse_equilibrium.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/reals.hpp"

namespace stickslip {
namespace {

using namespace large_detail;
using statics_detail::StaticsModel;

/// Returns the proof that statics gives, if it says that the bodies must move.
std::optional<Unstable> must_move(const GraspBox& grasp, SearchWork& work) {
  const StaticsModel model(grasp, 1);
  const auto y = statics_detail::unopposed_motion(model, model.load());
  if (!y) return std::nullopt;
  ++work.nodes;
  ++work.leaves;
  return Unstable{{TwistLeaf{negated(primitive_multiple(model.state_of(*y)))}}};
}

/// Requires that lengths of normals of contacts with preload are rational.
LargeGrasp large_grasp(const GraspBox& grasp) {
  LargeGrasp result{StaticsModel(grasp, 1, false)};
  for (const statics_detail::ForceCone& cone : result.model.cones()) {
    if (*cone.element >= grasp.contacts.size()) {
      const Spring& ratchet = grasp.springs[*cone.element - grasp.contacts.size()];
      result.cone_law.push_back({ratchet.force.low, ratchet.stiffness.low});
      result.frictions.emplace_back(0);
      continue;
    }
    const UncertainContact& c = grasp.contacts[*cone.element];
    const Rational square = dot(c.normal, c.normal);
    SpringLaw law{0, c.stiffness.low / square};
    if (!c.preload.low.is_zero()) law.preload = c.preload.low / exact_sqrt(square).value();
    result.cone_law.push_back(std::move(law));
    result.frictions.push_back(c.friction.low);
  }
  for (const Spring& spring : grasp.springs) {
    if (spring.is_ratchet() || spring.stiffness.low.is_zero()) continue;
    result.springs.push_back(sparse(spring.row));
    result.spring_law.push_back({spring.force.low, spring.stiffness.low});
  }
  return result;
}

Undecided undecided(const std::string& why) {
  return {"of more than " + std::to_string(kMostCoordinates - 2) +
              " coordinates no motions are searched: statics does not refute the load, and " +
              why,
          "size", "statics says what holds for any stiffness"};
}

const char* in_words(NoEquilibrium reason) {
  switch (reason) {
    case NoEquilibrium::kIrrational:
      return "contacts seem to slip, where friction has irrational numbers";
    case NoEquilibrium::kOpens:
      return "in the equilibrium that was found contacts open";
    default:
      return "near that in doubles no exact equilibrium was found";
  }
}

}  // namespace

bool is_large(const GraspBox& grasp) {
  return grasp.wrench.size() + 2 > kMostCoordinates;
}

BoxDecision decide_large(const GraspBox& grasp, NormalLaw law) {
  BoxDecision decision{Undecided{}};
  if (auto proof = must_move(grasp, decision.work)) {
    decision.verdict = std::move(*proof);
    return decision;
  }
  if (needs_enclosure(grasp)) {
    decision.verdict = undecided("a contact with preload has a normal of irrational length");
    return decision;
  }
  LargeGrasp large = large_grasp(grasp);
  large.may_open = law == NormalLaw::kUnilateral;
  std::optional<ShareWitness> witness;
  bool drifts = false;
  const char* why = "Newton's method found no equilibrium";
  for (const Smoothing smoothing : {Smoothing::kPulling, Smoothing::kPressed}) {
    const auto proposal = propose(large, smoothing);
    if (!proposal) continue;
    drifts = drifts || proposal->drifts;
    auto found = equilibrium_near(large, *proposal);
    if (auto* exact = std::get_if<ShareWitness>(&found)) {
      witness = std::move(*exact);
      break;
    }
    why = in_words(std::get<NoEquilibrium>(found));
  }
  if (!witness) {
    decision.verdict =
        undecided(drifts ? "in doubles bodies drift away as if nothing held them" : why);
    return decision;
  }
  if (!grasp.allows(witness->twist)) {
    decision.verdict = undecided("the motion of the equilibrium that was found is too large");
    return decision;
  }
  RationalRow motion = witness->twist;
  decision.verdict = Stable{std::move(*witness), std::move(motion)};
  return decision;
}

}  // namespace stickslip
