// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "stickslip/equilibrium/grasp_wrench_space.hpp"
#include "unit_edges.hpp"

namespace stickslip {
namespace {

/// > 0 when a, b, c turn left.
Rational turn(const Vector2& a, const Vector2& b, const Vector2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Andrew's monotone chain (Inf. Proc. Letters 9(5), 1979).
std::vector<Vector2> convex_hull(std::vector<Vector2> points) {
  std::sort(points.begin(), points.end(), [](const Vector2& a, const Vector2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vector2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Vector2& p : points) {
      while (hull.size() >= start + 2 &&
             turn(hull[hull.size() - 2], hull.back(), p).sign() <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();  // the other pass starts with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

std::vector<Vector2> zero_torque_slice(const Problem& problem) {
  std::vector<Vector3> points{{0, 0, 0}};
  for (const UnitEdges& e : unit_edges(problem, 1)) {
    points.push_back(e.plus);
    points.push_back(e.minus);
  }
  // A vertex of the slice lies on an edge of the space, so on a segment between two points.
  std::vector<Vector2> crossings;
  for (const Vector3& p : points) {
    if (p[2].is_zero()) crossings.push_back({p[0], p[1]});
    if (p[2].sign() <= 0) continue;
    for (const Vector3& q : points) {
      if (q[2].sign() >= 0) continue;
      const Rational s = p[2] / (p[2] - q[2]);
      crossings.push_back({p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])});
    }
  }
  return convex_hull(std::move(crossings));
}

}  // namespace stickslip
