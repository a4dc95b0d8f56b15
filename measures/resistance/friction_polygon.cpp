// SPDX-License-Identifier: GPL-3.0-or-later
#include "friction_polygon.hpp"

#include <algorithm>

namespace stickslip::resistance_detail {

/// The segments are turned into the half-plane to the left of the first, and sorted by angle.
std::vector<PolygonStep> half_way_round(const std::vector<IntegerVector3>& tangents,
                                        const IntegerVector3& axis) {
  std::vector<IntegerVector3> across;  // a quarter turn to the left of each, as seen
  for (const IntegerVector3& t : tangents) across.push_back(cross(axis, t));
  std::vector<PolygonStep> steps;
  for (std::size_t k = 0; k < tangents.size(); ++k) {
    int side = dot(across.front(), tangents[k]).sign();
    if (side == 0) side = dot(across.front(), across[k]).sign();
    steps.push_back({k, side});
  }
  std::sort(steps.begin(), steps.end(), [&](const PolygonStep& a, const PolygonStep& b) {
    return a.end * b.end * dot(across[a.segment], tangents[b.segment]).sign() > 0;
  });
  return steps;
}

}  // namespace stickslip::resistance_detail
