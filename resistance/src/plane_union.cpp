// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unbounded cells are cut off by a square frame that has all their vertices, and all crossings
// of their rays, strictly inside: beyond it there is nothing but rays that no longer meet, so
// that what is inside says all. In what comes back, ends on the frame are ends at infinity.
#include "stickslip/resistance/plane_union.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "plane_overlay.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using namespace resistance_detail;

namespace {

/// Half the side of the frame; 0 if all cells are bounded. Two rays on lines with integer
/// coefficients of at most M meet, by Cramer's rule, at coordinates of at most 2 M^2.
Integer frame_of(const std::vector<PlaneCell>& cells) {
  Integer vertices = 0;
  Integer coefficients = 0;
  bool unbounded = false;
  for (const PlaneCell& cell : cells) {
    unbounded = unbounded || !cell.is_bounded();
    for (const PlanePoint& point : cell.vertices()) {
      for (const Rational& value : point) {
        vertices = std::max<Integer>(vertices, abs(numerator(value)) / denominator(value));
      }
    }
    for (const PlaneEdge& edge : cell.edges()) {
      if (!is_at_infinity(edge.from) && !is_at_infinity(edge.to)) continue;
      const HomogeneousPoint& f = edge.from;
      const HomogeneousPoint& t = edge.to;
      const HomogeneousPoint line = primitive<3>(
          {f[1] * t[2] - f[2] * t[1], f[2] * t[0] - f[0] * t[2], f[0] * t[1] - f[1] * t[0]});
      for (const Integer& c : line) coefficients = std::max<Integer>(coefficients, abs(c));
    }
  }
  if (!unbounded) return 0;
  return 1 + std::max<Integer>(vertices + 1, 2 * coefficients * coefficients);
}

bool is_on_frame(const PlanePoint& point, const Integer& frame) {
  return !frame.is_zero() &&
         (abs(point[0]) == Rational(frame) || abs(point[1]) == Rational(frame));
}

PlaneDirection direction(const PlanePoint& from, const PlanePoint& to) {
  return primitive_multiple<2>({to[0] - from[0], to[1] - from[1]});
}

/// The point of the line nearest to the origin.
PlanePoint foot(const PlanePoint& point, const PlaneDirection& along) {
  return PlaneCell::hull({homogeneous(point), homogeneous(along), homogeneous(negated(along))})
      .vertices()
      .front();
}

Outline outline_of(const OverlayChain& chain) {
  Outline outline;
  const std::vector<PlanePoint>& points = chain.points;
  const std::size_t n = points.size();
  const std::size_t ends = chain.is_closed ? 0 : 1;
  for (std::size_t i = ends; i + ends < n; ++i) {
    if (direction(points[(i + n - 1) % n], points[i]) !=
        direction(points[i], points[(i + 1) % n])) {
      outline.vertices.push_back(points[i]);
    }
  }
  std::vector<PlanePoint>& vertices = outline.vertices;
  if (!chain.is_closed) {
    outline.from = direction(points[1], points[0]);
    outline.to = direction(points[n - 2], points[n - 1]);
    if (vertices.empty()) vertices.push_back(foot(points.front(), *outline.to));
    return outline;
  }
  // A vertex may be there twice, so compare what follows it, too.
  std::vector<PlanePoint> least = vertices;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
    if (vertices < least) least = vertices;
  }
  vertices = std::move(least);
  return outline;
}

/// By the least vertex, which is convex iff the outline runs counterclockwise.
bool is_hole(const Outline& outline) {
  if (!outline.is_closed()) return false;
  const std::vector<PlanePoint>& v = outline.vertices;
  return determinant(homogeneous(v.back()), homogeneous(v[0]), homogeneous(v[1])).sign() < 0;
}

/// 0: the outside, 1: open, 2: a hole.
auto order_of(const Outline& outline) {
  return std::make_tuple(!outline.is_closed() ? 1
                         : is_hole(outline)   ? 2
                                              : 0,
                         std::cref(outline.vertices), outline.from, outline.to);
}

bool comes_before(const Outline& a, const Outline& b) {
  return order_of(a) < order_of(b);
}

/// As long as possible, and with ends on the frame at infinity.
std::vector<PlaneCell> merge_thin_edges(const Overlay& overlay, const Integer& frame) {
  // Edges of one line in order; lines by direction and foot.
  using Edge = std::pair<PlanePoint, PlanePoint>;
  std::map<std::pair<PlaneDirection, PlanePoint>, std::vector<Edge>> lines;
  for (Edge edge : overlay.thin_edges) {
    if (edge.second < edge.first) std::swap(edge.first, edge.second);
    const PlaneDirection along = direction(edge.first, edge.second);
    lines[{along, foot(edge.first, along)}].push_back(std::move(edge));
  }
  std::vector<PlaneCell> curves;
  for (auto& [line, edges] : lines) {
    std::sort(edges.begin(), edges.end());
    for (auto edge = edges.begin(); edge != edges.end();) {
      PlanePoint low = edge->first;
      PlanePoint high = edge->second;
      for (++edge; edge != edges.end() && edge->first == high; ++edge) high = edge->second;
      const bool from_infinity = is_on_frame(low, frame);
      const bool to_infinity = is_on_frame(high, frame);
      if (from_infinity && to_infinity) low = line.second;
      std::vector<HomogeneousPoint> generators;
      if (!from_infinity || to_infinity) generators.push_back(homogeneous(low));
      if (!to_infinity) generators.push_back(homogeneous(high));
      if (from_infinity) generators.push_back(homogeneous(negated(line.first)));
      if (to_infinity) generators.push_back(homogeneous(line.first));
      curves.push_back(PlaneCell::hull(std::move(generators)));
    }
  }
  std::sort(curves.begin(), curves.end());
  return curves;
}

/// Where the edge from `upper` to `lower` meets a line from p in direction `along` (see
/// is_inside): how far from p and, to tell ties, how the distance grows below the line.
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

/// Shoots from p towards an edge's middle. The first edge met tells on which side p is. The
/// line is taken a little to the right of p, so that it meets no vertex.
bool is_inside(const PlaneArea& area, const HomogeneousPoint& p) {
  std::vector<PlaneEdge> edges;
  for (const Outline& outline : area.outlines) {
    for (PlaneEdge& edge : outline.edges()) {
      if (edge.contains(p)) return true;
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
  const std::set<PlaneCell> distinct(cells.begin(), cells.end());
  const Integer frame = frame_of(cells);
  std::vector<PlaneCell> framed;
  std::vector<PlanePoint> points;
  for (const PlaneCell& cell : distinct) {
    if (cell.dimension() == 0) {
      points.push_back(cell.vertices().front());
    } else if (cell.is_bounded()) {
      framed.push_back(cell);
    } else {
      const Rational side(frame);
      framed.push_back(*clip_to_box(cell, {-side, -side}, {side, side}));
    }
  }
  PlaneUnion result;
  if (!framed.empty()) {
    const Overlay found = overlay(framed, frame);
    result.areas.resize(found.areas);
    for (const OverlayChain& chain : found.chains) {
      result.areas[chain.area].outlines.push_back(outline_of(chain));
    }
    for (PlaneArea& area : result.areas) {
      std::sort(area.outlines.begin(), area.outlines.end(), comes_before);
    }
    std::sort(result.areas.begin(), result.areas.end(), [](const auto& a, const auto& b) {
      return std::lexicographical_compare(a.outlines.begin(), a.outlines.end(),
                                          b.outlines.begin(), b.outlines.end(), comes_before);
    });
    result.curves = merge_thin_edges(found, frame);
  }
  for (const PlanePoint& point : points) {
    if (!result.contains(point)) result.points.push_back(point);
  }
  return result;
}

}  // namespace stickslip
