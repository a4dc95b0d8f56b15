// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/motion/strict_cone.hpp"

namespace stickslip {

std::pair<StrictCone, StrictCone> StrictCone::halves(const Row& plane) const {
  auto [above, below] = cone_.halves(plane);
  std::pair<StrictCone, StrictCone> both(*this, *this);
  both.second.strict_.push_back(cone_.constraint_count());
  both.first.cone_ = std::move(above);
  both.second.cone_ = std::move(below);
  return both;
}

/// All constraints are 0 on lines, which take nothing away.
bool StrictCone::bars(const std::vector<std::size_t>& zeros) const {
  const std::size_t lines = 2 * cone_.lines().size();
  return std::any_of(strict_.begin(), strict_.end(), [&](ConstraintIndex strict) {
    return std::all_of(zeros.begin(), zeros.end(), [&](std::size_t point) {
      if (point < lines) return true;
      const std::vector<ConstraintIndex>& tight = cone_.rays()[point - lines].tight;
      return std::binary_search(tight.begin(), tight.end(), strict);
    });
  });
}

void StrictCone::cut_to_wall(const ConvexBody& body, std::size_t wall) {
  const auto plane = [&](std::size_t j, int height) {  // E_j.(d - h d0) - height h
    RationalRow a = body.walls[j];
    a.emplace_back(-dot(body.walls[j], body.twist) - height);
    a.emplace_back(0);
    return primitive_multiple(a);
  };
  const std::size_t row = body.is_simplex ? wall : wall / 2;
  cut(plane(row, body.is_simplex || wall % 2 == 0 ? 1 : -1), Side::kZero);
  for (std::size_t j = 0; j < body.walls.size(); ++j) {
    if (j == row) continue;
    cut(plane(j, 1), Side::kNegative);
    if (!body.is_simplex) cut(plane(j, -1), Side::kPositive);
  }
}

PlaneSigns StrictCone::signs(const Row& plane) const {
  PlaneSigns signs;
  std::vector<std::size_t> zeros;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const int sign = dot(plane, points_[p]).sign();
    if (sign > 0) signs.positive = true;
    if (sign < 0) signs.negative = true;
    if (sign == 0) zeros.push_back(p);
    if (signs.cuts()) return signs;
  }
  signs.zeros_barred = bars(zeros);
  return signs;
}

}  // namespace stickslip
