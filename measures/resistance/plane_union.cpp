// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/plane_union.hpp"

#include <algorithm>
#include <set>

#include "plane_cover.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using namespace resistance_detail;

namespace {

/// Returns where the edge from `upper` to `lower` meets a line from p in direction `along` (see
/// is_inside): the distance from p and, to break ties, how it grows below the line.
std::pair<Rational, Rational> distance(const PlaneDirection& along, const HomogeneousPoint& p,
                                       const HomogeneousPoint& upper, const Integer& above,
                                       const HomogeneousPoint& lower, const Integer& below) {
  HomogeneousPoint meet;
  for (std::size_t j = 0; j < 3; ++j) meet[j] = above * lower[j] - below * upper[j];
  const auto along_at = [&](const HomogeneousPoint& g) {
    return Rational(along[0] * g[0] + along[1] * g[1], g[2]);
  };
  const PlaneDirection down = PlaneEdge{upper, lower}.direction();
  const Integer sinking = along[1] * down[0] - along[0] * down[1];
  return {along_at(meet) - along_at(p), Rational(dot(along, down), sinking)};
}

/// Returns true if p is inside. Shoots from p towards an edge's middle; the first edge met
/// tells on which side p is. The line is taken a little to the right of p, so that it meets no
/// vertex.
bool is_inside(const PlaneArea& area, const HomogeneousPoint& p) {
  std::vector<PlaneEdge> edges;
  for (const Outline& outline : area.outlines) {
    for (PlaneEdge& edge : outline.edges()) {
      if (determinant(edge.from, edge.to, p).is_zero() &&
          PlaneCell::hull({edge.from, edge.to}).contains(point_of(p))) {
        return true;
      }
      edges.push_back(std::move(edge));
    }
  }
  if (edges.empty()) return true;
  const auto aim = std::find_if(edges.begin(), edges.end(), [&](const PlaneEdge& edge) {
    return !determinant(edge.from, edge.to, p).is_zero();
  });
  require(aim != edges.end(), "all edges lie on lines through a point beside them");
  HomogeneousPoint q;  // a positive combination of the ends is between them
  for (std::size_t j = 0; j < 3; ++j) q[j] = aim->from[j] + aim->to[j];
  const PlaneDirection along = PlaneEdge{p, q}.direction();

  std::optional<std::pair<Rational, Rational>> nearest;
  bool inside = false;
  for (const PlaneEdge& edge : edges) {
    Integer from = determinant(p, q, edge.from);
    Integer to = determinant(p, q, edge.to);
    // A ray along the line stays on the side of its vertex.
    if (is_at_infinity(edge.from) && from.is_zero()) from = to;
    if (is_at_infinity(edge.to) && to.is_zero()) to = from;
    const bool rises = to.sign() >= 0;
    if ((from.sign() >= 0) == rises) continue;
    const auto found = rises ? distance(along, p, edge.to, to, edge.from, from)
                             : distance(along, p, edge.from, from, edge.to, to);
    if (found.first.sign() < 0 || (nearest && *nearest < found)) continue;
    nearest = found;
    inside = rises;
  }
  require(nearest.has_value(), "a line to an edge meets none");
  return inside;
}

}  // namespace

std::vector<PlaneEdge> Outline::edges() const {
  std::vector<HomogeneousPoint> ends;
  if (from) ends.push_back(homogeneous(*from));
  for (const PlanePoint& point : vertices) ends.push_back(homogeneous(point));
  ends.push_back(to ? homogeneous(*to) : ends.front());
  std::vector<PlaneEdge> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) result.push_back({ends[i], ends[i + 1]});
  return result;
}

bool PlaneUnion::contains(const PlanePoint& point) const {
  const HomogeneousPoint p = homogeneous(point);
  return std::find(points.begin(), points.end(), point) != points.end() ||
         std::any_of(curves.begin(), curves.end(),
                     [&](const PlaneCell& curve) { return curve.contains(point); }) ||
         std::any_of(areas.begin(), areas.end(),
                     [&](const PlaneArea& area) { return is_inside(area, p); });
}

PlaneUnion unite(const std::vector<PlaneCell>& cells) {
  PlaneCover cover;
  for (const PlaneCell& cell : std::set<PlaneCell>(cells.begin(), cells.end())) cover.add(cell);
  return cover.covered();
}

PlaneUnion clip_to_box(const PlaneUnion& region, const PlanePoint& low,
                       const PlanePoint& high) {
  PlaneCover cover;
  cover.add(PlaneCell::hull({homogeneous(low), homogeneous(PlanePoint{high[0], low[1]}),
                             homogeneous(high), homogeneous(PlanePoint{low[0], high[1]})}));
  cover.add(region.areas);
  PlaneUnion result;
  result.areas = cover.covered(2).areas;
  std::set<PlanePoint> points(region.points.begin(), region.points.end());
  for (const PlaneCell& curve : region.curves) {
    const std::optional<PlaneCell> part = clip_to_box(curve, low, high);
    if (!part) continue;
    if (part->dimension() == 1) result.curves.push_back(*part);
    if (part->dimension() == 0) points.insert(part->vertices().front());
  }
  std::sort(result.curves.begin(), result.curves.end());
  for (const PlanePoint& point : points) {
    const bool is_in_box =
        low[0] <= point[0] && point[0] <= high[0] && low[1] <= point[1] && point[1] <= high[1];
    if (is_in_box && !result.contains(point)) result.points.push_back(point);
  }
  return result;
}

}  // namespace stickslip
