// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/crosscheck/claim.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/contact_mode.hpp"

namespace stickslip {
namespace {

std::vector<Sign> slip_of(const Problem& problem, const Twist& twist) {
  std::vector<Sign> slip;
  for (const ContactMode mode : modes_of(problem, twist)) slip.push_back(mode.slip);
  return slip;
}

Rational largest_difference(const Twist& a, const Twist& b) {
  return std::max<Rational>({abs(a.x - b.x), abs(a.y - b.y), abs(a.r - b.r)});
}

NearbyEquilibrium compare(const Problem& problem, const ApproximateEquilibrium& claimed,
                          Witness witness, bool from_claim) {
  NearbyEquilibrium result;
  result.from_claim = from_claim;
  if (claimed.twist) {
    result.twist_distance = largest_difference(*claimed.twist, witness.twist);
    result.same_slip = slip_of(problem, *claimed.twist) == slip_of(problem, witness.twist);
  }
  if (claimed.forces) result.force_distance = Rational(0);
  result.same_contacts = true;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactForce& found = witness.forces[i];
    const bool bears = claimed.forces ? (*claimed.forces)[i].normal.sign() > 0
                                      : row.normal_coefficient(*claimed.twist).sign() > 0;
    if (bears != (found.normal.sign() > 0)) result.same_contacts = false;
    if (!claimed.forces) continue;
    const ContactForce& claim = (*claimed.forces)[i];
    const Wrench difference = (found.normal - claim.normal) * row.normal +
                              (found.tangential - claim.tangential) * row.tangent;
    result.force_distance =
        std::max<Rational>({*result.force_distance, abs(difference.x), abs(difference.y)});
  }
  result.witness = std::move(witness);
  return result;
}

}  // namespace

const char* name_of(ClaimClass claim_class) {
  constexpr const char* kNames[] = {"right", "tie", "wrong", "undecided"};
  return kNames[static_cast<std::size_t>(claim_class)];
}

ClaimReport judge_claim(const Question& question, const Claim& claim,
                        const ClaimOptions& options) {
  const Problem problem = problem_of(question);
  const ApproximateEquilibrium& solution = claim.solution;
  if (solution.forces && solution.forces->size() != problem.size()) {
    throw InputError("", "", std::to_string(solution.forces->size()) + " forces are claimed",
                     "the grasp has " + std::to_string(problem.size()) +
                         " contacts; give one force for each, in their order");
  }
  ConeOptions cone;
  cone.node_limit = options.node_limit;
  ClaimReport report;
  report.decision = decide(problem, Engine::kAuto, cone);
  report.residuals = residuals_of(problem, solution);
  report.scale = residual_scale(question.loaded(), solution);
  if (solution.twist) report.claimed_slip = slip_of(problem, *solution.twist);

  const auto* stable = std::get_if<Stable>(&report.decision.verdict);
  if (stable != nullptr && claim.stable && (solution.twist || solution.forces)) {
    auto witness = find_witness_like(problem, solution);
    const bool from_claim = witness.has_value();
    report.nearby = compare(problem, solution,
                            from_claim ? std::move(*witness) : stable->witness(), from_claim);
  }
  const bool decided = !std::holds_alternative<Undecided>(report.decision.verdict);
  const bool agrees = decided && claim.stable == (stable != nullptr);
  if (decided && (!agrees || options.all_distances)) {
    report.distance = threshold_distance(problem, question.loaded().grasp, cone);
  }
  if (agrees) {
    report.claim_class = ClaimClass::kRight;
    report.inaccurate =
        claim.stable &&
        !report.residuals.missed(options.residual_tolerance, report.scale).empty();
  } else if (decided) {
    const auto smallest = report.distance->smallest();
    report.claim_class = smallest && *smallest <= options.tie_distance ? ClaimClass::kTie
                         : report.distance->limit                      ? ClaimClass::kUndecided
                                                                       : ClaimClass::kWrong;
  }
  return report;
}

}  // namespace stickslip
