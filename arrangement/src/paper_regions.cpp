// SPDX-License-Identifier: GPL-3.0-or-later
// Step 1: Algorithm 1 of the paper.
#include <utility>
#include <variant>

#include "stickslip/arrangement/paper_enumerator.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {
namespace {

/// side n.d - t, over the variables (d, t).
std::vector<Rational> margin_row(const Vector3& normal, Sign side) {
  std::vector<Rational> row(normal.begin(), normal.end());
  if (side == Sign::kNegative) {
    for (Rational& entry : row) entry = -entry;
  }
  row.emplace_back(-1);
  return row;
}

/// Whether some d has s_j n_j.d > 0 for the signs of `region`, and side n_i.d > 0 for the
/// plane i that comes next. The largest margin t is bounded by the row t <= 1.
bool has_component(const std::vector<Vector3>& normals, const SlipState& region, Sign side,
                   PaperWork& work) {
  LinearProgram program;
  program.add_variables(4, VariableKind::kFree);
  for (std::size_t j = 0; j < region.size(); ++j) {
    program.add_row(margin_row(normals[j], region[j]), Relation::kGreaterEqual, 0);
  }
  program.add_row(margin_row(normals[region.size()], side), Relation::kGreaterEqual, 0);
  program.add_row({0, 0, 0, 1}, Relation::kLessEqual, 1);
  program.minimize({0, 0, 0, -1});

  LpWork lp_work;
  const LpResult result = solve(program, &lp_work);
  ++work.linear_programs;
  work.pivots += static_cast<std::size_t>(lp_work.double_pivots + lp_work.exact_pivots);
  const Optimal* optimal = std::get_if<Optimal>(&result);
  require(optimal != nullptr, "paper_regions: the margin of a region must have an optimum");
  return optimal->value < 0;
}

}  // namespace

std::vector<SlipState> paper_regions(const std::vector<Vector3>& plane_normals,
                                     PaperWork* work) {
  for (const Vector3& n : plane_normals) {
    require(n[0] != 0 || n[1] != 0 || n[2] != 0,
            "paper_regions: the normal of a plane is zero");
  }
  PaperWork ignored;
  PaperWork& counters = work != nullptr ? *work : ignored;
  std::vector<SlipState> regions(1);
  for (std::size_t i = 0; i < plane_normals.size(); ++i) {
    std::vector<SlipState> split;
    for (const SlipState& region : regions) {
      for (const Sign side : {Sign::kPositive, Sign::kNegative}) {
        if (!has_component(plane_normals, region, side, counters)) continue;
        split.push_back(region);
        split.back().push_back(side);
      }
    }
    regions = std::move(split);
  }
  return regions;
}

}  // namespace stickslip
