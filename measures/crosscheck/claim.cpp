// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/claim.hpp"

#include <utility>

#include "nearby.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using namespace crosscheck_detail;

namespace {

void check_sizes(const Question& question, const Claim& claim) {
  const std::size_t coordinates = question.in_space() ? 6 : 3;
  require(!claim.twist || claim.twist->size() == coordinates, "a motion of this grasp");
  if (!claim.forces) return;
  const std::size_t contacts = question.box() != nullptr ? question.box()->contacts.size()
                                                         : question.loaded().grasp.size();
  if (claim.forces->size() != contacts) {
    throw InputError("", "", std::to_string(claim.forces->size()) + " forces are claimed",
                     "the grasp has " + std::to_string(contacts) +
                         " contacts; give one force for each, in their order");
  }
  for (const RationalRow& force : *claim.forces) {
    require(force.size() == coordinates / 3 + 1, "forces on this grasp");
  }
}

/// Returns true if the claimed motion is within the bound on motions, or one of the two is not
/// given.
bool is_allowed(const Claim& claim, const GraspBox& grasp) {
  return !claim.twist || grasp.allows(*claim.twist);
}

/// Returns the class of a claim with another verdict than the exact one.
ClaimClass class_of(const ThresholdDistance& distance, const Rational& tie_distance) {
  const auto smallest = distance.smallest();
  if (!smallest) return ClaimClass::kWrong;
  if (smallest->high && *smallest->high <= tie_distance) return ClaimClass::kTie;
  const bool is_beyond = smallest->low > tie_distance ||
                         (distance.all_at_once && distance.all_at_once->low >= tie_distance);
  return is_beyond ? ClaimClass::kWrong : ClaimClass::kUndecided;
}

}  // namespace

const char* name_of(ClaimClass claim_class) {
  constexpr const char* kNames[] = {"right", "tie", "wrong", "undecided"};
  return kNames[static_cast<std::size_t>(claim_class)];
}

ClaimReport judge_claim(const Question& question, const Claim& claim,
                        const ClaimOptions& options) {
  require_one_grasp(question);
  check_sizes(question, claim);
  ClaimReport report;
  SearchOptions search = by(Engine::kBranchAndBound);
  search.node_limit = options.node_limit;
  search.second = false;
  report.answer = decide(question, search);
  const GraspBox grasp = question.grasp.as_box();
  report.residuals = residuals_of(grasp, question.law, claim);
  report.scale = residual_scale(grasp, claim);
  if (claim.twist) report.claimed_slip = slip_of(grasp, *claim.twist);

  const bool is_exact = is_equilibrium(report.residuals) && is_allowed(claim, grasp);
  if (is_exact) {
    Verdict& exact = report.answer.verdict;
    require(!std::holds_alternative<Unstable>(exact), "a refutation of an equilibrium");
    if (std::holds_alternative<Undecided>(exact) && question.box() != nullptr) {
      if (auto stable = verdict_by(question, claim)) exact = std::move(*stable);
    }
  }
  const std::optional<bool> stable = is_stable(report.answer.verdict);
  if (!stable) return report;
  if (*stable && claim.stable && (claim.twist || claim.forces)) {
    report.nearby = nearby_equilibrium(grasp, report.answer, claim, is_exact);
    if (!report.nearby) report.no_nearby = "the exact verdict is proved without stating one";
  }
  const bool agrees = claim.stable == *stable;
  if (!agrees || options.all_distances) {
    report.distance = threshold_distance(question, *stable, options);
  }
  if (agrees) {
    report.claim_class = ClaimClass::kRight;
    report.inaccurate =
        claim.stable &&
        !report.residuals.missed(options.residual_tolerance, report.scale).empty();
  } else {
    report.claim_class = class_of(*report.distance, options.tie_distance);
  }
  return report;
}

}  // namespace stickslip
