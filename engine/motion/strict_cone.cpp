// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/strict_cone.hpp"

namespace stickslip {
namespace {

void assign(Row& to, Row plane) {
  to = std::move(plane);
}

void assign(IntegerVector5& to, const Row& plane) {
  to = vector_of<5>(plane);
}

}  // namespace

template <class Vector>
void StrictConeOf<Vector>::cut_to_wall(const ConvexBody& body, std::size_t wall) {
  const auto plane = [&](std::size_t j, int height) {  // E_j.(d - h d0) - height h
    RationalRow a = body.walls[j];
    a.emplace_back(-dot(body.walls[j], body.twist) - height);
    a.emplace_back(0);
    Vector result;
    assign(result, primitive_multiple(a));
    return result;
  };
  const std::size_t row = body.is_simplex ? wall : wall / 2;
  cut(plane(row, body.is_simplex || wall % 2 == 0 ? 1 : -1), Side::kZero);
  for (std::size_t j = 0; j < body.walls.size(); ++j) {
    if (j == row) continue;
    cut(plane(j, 1), Side::kNegative);
    if (!body.is_simplex) cut(plane(j, -1), Side::kPositive);
  }
}

template class StrictConeOf<IntegerVector5>;
template class StrictConeOf<Row>;

std::vector<StrictCone> StrictCone::parts(const Row& plane,
                                          const std::vector<StrictSide>& sides) const {
  std::vector<Side> kept;
  for (const StrictSide& side : sides) kept.push_back(side.side);
  std::vector<StrictCone> result;
  for (ConeOf<Row>& cone : cone_.parts(plane, kept)) {
    StrictCone& part = result.emplace_back(motions_);
    part.strict_ = strict_;
    if (sides[result.size() - 1].strict) part.strict_.push_back(cone_.constraint_count());
    part.cone_ = std::move(cone);
  }
  return result;
}

/// Lines take nothing away, as all constraints are 0 on them.
bool StrictCone::bars(const std::vector<std::size_t>& zeros) const {
  const std::size_t lines = 2 * cone_.lines().size();
  std::vector<std::size_t> rays;
  for (const std::size_t point : zeros) {
    if (point >= lines) rays.push_back(point - lines);
  }
  return StrictConeOf::bars(
      rays, [&](std::size_t ray) -> const auto& { return cone_.rays()[ray].tight; });
}

std::vector<std::vector<std::size_t>> StrictCone::strict_points() const {
  const std::size_t lines = 2 * cone_.lines().size();
  std::vector<std::vector<std::size_t>> result;
  for (const ConstraintIndex strict : strict_) {
    std::vector<std::size_t>& points = result.emplace_back();
    for (std::size_t ray = 0; ray < cone_.rays().size(); ++ray) {
      const std::vector<ConstraintIndex>& zero = cone_.rays()[ray].tight;
      if (!std::binary_search(zero.begin(), zero.end(), strict)) points.push_back(lines + ray);
    }
  }
  return result;
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
