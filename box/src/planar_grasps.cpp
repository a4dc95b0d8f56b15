// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar_grasps.hpp"

#include "stickslip/equilibrium/decide.hpp"

namespace stickslip::box_detail {

Problem problem_of(const GraspLaw& point) {
  const auto as_wrench = [](const RationalRow& row) { return Wrench{row[0], row[1], row[2]}; };
  std::vector<ContactRow> rows;
  for (const LawContact& c : point.contacts) {
    const CornerRow& row = c.corners.front();
    rows.push_back({as_wrench(row.normal), as_wrench(row.wrench_of({1})), c.friction.low,
                    c.preload.low, c.stiffness.low});
  }
  const std::vector<Interval>& w = point.wrench;
  return Problem(std::move(rows), {w[0].low, w[1].low, w[2].low}, point.law);
}

std::vector<NearEquilibrium> near_equilibria(const GraspLaw& point, bool has_enclosures) {
  const Problem problem = problem_of(point);
  const RoundedGrasp grasp = rounded_middle(point);
  constexpr std::size_t kMost = 4;
  std::vector<NearEquilibrium> result;
  if (!has_enclosures && !has_long_equilibria(problem)) {
    const Verdict verdict = decide_by_cones(problem);
    const auto* stable = std::get_if<Stable>(&verdict);
    if (stable == nullptr) return result;
    result.push_back(near(grasp, rounded_equilibrium(problem, stable->witness)));
    constexpr std::size_t kStarts = 40;
    for (const Witness& witness : find_equilibria(problem, kStarts)) {
      if (result.size() == kMost) break;
      result.push_back(near(grasp, rounded_equilibrium(problem, witness)));
    }
    return result;
  }
  constexpr std::size_t kStarts = 12;
  for (const std::size_t starts : {std::size_t{0}, kStarts}) {
    for (const RoundedEquilibrium& found : find_rounded_equilibria(problem, starts)) {
      if (result.size() <= kMost) result.push_back(near(grasp, found));
    }
  }
  return result;
}

}  // namespace stickslip::box_detail
