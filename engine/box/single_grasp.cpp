// SPDX-License-Identifier: GPL-3.0-or-later
#include "single_grasp.hpp"

#include <cmath>
#include <utility>

#include "engine/degree/equilibria_by_states.hpp"
#include "engine/degree/newton.hpp"
#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/engine/newton_equilibria.hpp"

namespace stickslip::box_detail {

namespace {

/// Returns equilibria at which all that presses and rubs sticks. They are proved at once,
/// whatever the unit; the engine of the plane does not tell by itself that they stick.
std::vector<NearEquilibrium> sticking_equilibria(const GraspLaw& point,
                                                 const RoundedGrasp& grasp) {
  constexpr std::size_t kFewContacts = 64;
  if (point.contacts.size() > kFewContacts) return {};
  std::vector<NearEquilibrium> result;
  for (NearEquilibrium& found : Newton(grasp).solve_from(1)) {
    bool sticks = true;
    for (std::size_t i = 0; i < point.contacts.size(); ++i) {
      const bool rubs = found.normal[i] > 0 && point.contacts[i].slopes[1] > 0;
      sticks = sticks && (!rubs || found.sticks[i] != 0);
    }
    if (sticks) result.push_back(std::move(found));
  }
  return result;
}

}  // namespace

std::vector<NearEquilibrium> equilibria_in_doubles(const GraspLaw& point, bool has_enclosures) {
  const RoundedGrasp grasp = rounded_middle(point);
  const std::optional<Problem> one = point.problem();
  if (!one) {
    constexpr std::size_t kStarts = 3;
    return Newton(grasp).solve_from(kStarts);
  }
  const Problem& problem = *one;
  constexpr std::size_t kMost = 4;  // the most of each kind
  std::vector<NearEquilibrium> result = sticking_equilibria(point, grasp);
  if (!has_enclosures) {
    for (NearEquilibrium& found : equilibria_by_states(grasp))
      result.push_back(std::move(found));
  }
  if (!has_enclosures && !has_long_equilibria(problem)) {
    const Verdict verdict = branch_and_bound(problem);
    const auto* stable = std::get_if<Stable>(&verdict);
    if (stable == nullptr) return {};
    result.push_back(rounded_equilibrium(problem, stable->witness(), grasp.length));
    constexpr std::size_t kStarts = 40;
    const std::size_t most = result.size() + kMost - 1;
    for (const Witness& witness : find_equilibria(problem, kStarts)) {
      if (result.size() == most) break;
      result.push_back(rounded_equilibrium(problem, witness, grasp.length));
    }
  }
  const std::size_t most = result.size() + kMost;
  constexpr std::size_t kStarts = 12;
  for (const std::size_t starts : {std::size_t{0}, kStarts}) {
    for (NearEquilibrium& found : newton_equilibria(problem, starts, grasp.length)) {
      if (result.size() <= most) result.push_back(std::move(found));
    }
  }
  return result;
}

bool is_beyond(const Law& law, const NearEquilibrium& near, const RationalRow& bound) {
  for (std::size_t j = 0; j < bound.size(); ++j) {
    constexpr double kNearly = 1 + 1e-6;
    const double d = near.motion[static_cast<Eigen::Index>(j)] / law.unit(j);
    if (std::fabs(d) > kNearly * to_double(bound[j])) return true;
  }
  return false;
}

bool may_be_within(const Law& law, const NearEquilibrium& near) {
  return !is_beyond(law, near, law.max_motion);
}

std::optional<bool> is_stable(const GraspBox& point, NormalLaw law,
                              const SearchOptions& options) {
  const AnyGrasp grasp = simplest(point);
  if (const LoadedGrasp* one = grasp.single()) {
    return std::holds_alternative<Stable>(branch_and_bound(Problem(*one, law)));
  }
  return stickslip::is_stable(decide_box(point, law, options).verdict);
}

}  // namespace stickslip::box_detail
