// SPDX-License-Identifier: GPL-3.0-or-later
//
// A square frame cuts off unbounded cells. It has all vertices, and all crossings of rays,
// strictly inside; beyond it there are only rays that no longer meet, so the part inside tells
// all. In the result, ends on the frame are ends at infinity.
#include "plane_cover.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "near_number.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::resistance_detail {
namespace {

bool is_on_frame(const PlanePoint& point, const Integer& frame) {
  return !frame.is_zero() &&
         (abs(point[0]) == Rational(frame) || abs(point[1]) == Rational(frame));
}

PlaneDirection direction(const PlanePoint& from, const PlanePoint& to) {
  return primitive_multiple<2>({to[0] - from[0], to[1] - from[1]});
}

/// Returns the point of the line nearest to the origin.
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
  // A vertex may be there twice, so the vertices that follow it are compared, too.
  std::vector<PlanePoint> least = vertices;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
    if (vertices < least) least = vertices;
  }
  vertices = std::move(least);
  return outline;
}

/// Returns true if the outline runs clockwise. At its least vertex the outline is convex iff it
/// runs counterclockwise.
bool is_hole(const Outline& outline) {
  if (!outline.is_closed()) return false;
  const std::vector<PlanePoint>& v = outline.vertices;
  return determinant(homogeneous(v.back()), homogeneous(v[0]), homogeneous(v[1])).sign() < 0;
}

/// Returns 0 for the outside, 1 for an open outline and 2 for a hole, as the order of outlines.
auto order_of(const Outline& outline) {
  return std::make_tuple(!outline.is_closed() ? 1
                         : is_hole(outline)   ? 2
                                              : 0,
                         std::cref(outline.vertices), outline.from, outline.to);
}

bool comes_before(const Outline& a, const Outline& b) {
  return order_of(a) < order_of(b);
}

/// Returns the thin edges as cells that are as long as possible; ends on the frame become
/// directions to infinity.
std::vector<PlaneCell> merge_thin_edges(const Overlay& overlay, const Integer& frame) {
  // Edges are sorted along their line; lines by direction and foot.
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

/// Returns the point where a ray leaves the frame.
PlanePoint exit_of(const HomogeneousPoint& start, const HomogeneousPoint& towards,
                   const Integer& frame) {
  const PlanePoint p = point_of(start);
  std::optional<Rational> way;
  for (std::size_t j = 0; j < 2; ++j) {
    if (towards[j].is_zero()) continue;
    const Rational side(towards[j].sign() > 0 ? frame : Integer(-frame));
    const Rational here = (side - p[j]) / Rational(towards[j]);
    if (!way || here < *way) way = here;
  }
  PlanePoint end;
  for (std::size_t j = 0; j < 2; ++j) end[j] = p[j] + *way * Rational(towards[j]);
  return end;
}

/// The edges of a cover within a frame; each point is listed once.
class FramedEdges {
 public:
  explicit FramedEdges(const Integer& frame) : frame_(frame) {}

  void add(const PlaneEdge& edge, int cells) {
    const auto end = [&](const HomogeneousPoint& at, const HomogeneousPoint& other) {
      if (!is_at_infinity(at)) return index_of(at);
      points.push_back(exit_of(other, at, frame_));
      return points.size() - 1;
    };
    const std::size_t from = end(edge.from, edge.to);
    edges.push_back({from, end(edge.to, edge.from), cells});
  }

  /// A change of the number of cells on the way round the frame, at the end of an edge that has
  /// been added.
  struct Change {
    std::pair<int, Rational> place;  ///< the side, counted from the right one, and how far
                                     ///< along it
    std::size_t point;
    int more;
  };
  Change change(std::size_t point, int more) const {
    return {place(points[point]), point, more};
  }
  std::size_t add_point(PlanePoint point) {
    points.push_back(std::move(point));
    return points.size() - 1;
  }

  /// Adds the parts of the frame that are inside of cells, as their borders, counterclockwise
  /// from `start`, which is in so many cells.
  void add_frame(std::size_t start, int cells, std::vector<Change> changes) {
    const Rational f(frame_);
    for (const PlanePoint& corner :
         {PlanePoint{f, -f}, PlanePoint{f, f}, PlanePoint{-f, f}, PlanePoint{-f, -f}}) {
      changes.push_back(change(add_point(corner), 0));
    }
    std::sort(changes.begin(), changes.end(),
              [](const Change& a, const Change& b) { return a.place < b.place; });
    const Change end = change(start, 0);
    std::rotate(changes.begin(),
                std::find_if(changes.begin(), changes.end(),
                             [&](const Change& change) { return end.place < change.place; }),
                changes.end());
    changes.push_back(end);
    const int at_start = cells;
    std::pair<int, Rational> place = end.place;
    std::size_t from = start;
    for (const Change& change : changes) {
      if (cells != 0 && change.place != place) edges.push_back({from, change.point, cells});
      place = change.place;
      from = change.point;
      cells += change.more;
    }
    require(cells == at_start, "round the frame cells are as many as before");
  }

  std::vector<PlanePoint> points;
  std::vector<OverlayEdge> edges;

 private:
  std::size_t index_of(const HomogeneousPoint& point) {
    const auto [found, is_new] = index_.emplace(point, points.size());
    if (is_new) points.push_back(point_of(point));
    return found->second;
  }

  std::pair<int, Rational> place(const PlanePoint& p) const {
    const Rational side(frame_);
    if (p[0] == side && p[1] < side) return {0, p[1]};
    if (p[1] == side && p[0] > -side) return {1, -p[0]};
    if (p[0] == -side && p[1] > -side) return {2, -p[1]};
    return {3, p[0]};
  }

  const Integer frame_;
  std::map<HomogeneousPoint, std::size_t> index_;
};

/// Returns the line over its largest entry, as estimates.
std::array<NearNumber, 3> estimates_of(const HomogeneousPoint& line) {
  const std::array<double, 3> values = in_doubles(line);
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  std::array<NearNumber, 3> result;
  for (std::size_t j = 0; j < 3; ++j) {
    const double value = values[j] / largest;
    if (!line[j].is_zero()) result[j] = {value, std::fabs(value) * 4 * kRounding + 0x1p-800};
  }
  return result;
}

/// Returns at least the size of the coordinates of the point where two lines cross, rounded up;
/// 0 if they do not cross.
Integer crossing_within(const HomogeneousPoint& a, const std::array<NearNumber, 3>& near_a,
                        const HomogeneousPoint& b, const std::array<NearNumber, 3>& near_b) {
  const auto minor = [](const auto& p, const auto& q, std::size_t j, std::size_t k) {
    return p[j] * q[k] - p[k] * q[j];
  };
  const NearNumber h = minor(near_a, near_b, 0, 1);
  if (h.sign() && *h.sign() != 0) {
    const double least = std::fabs(h.value) - h.error;
    double most = 0;
    for (const auto& [j, k] : {std::pair{1, 2}, std::pair{2, 0}}) {
      const NearNumber x =
          minor(near_a, near_b, static_cast<std::size_t>(j), static_cast<std::size_t>(k));
      most = std::max(most, (std::fabs(x.value) + x.error) / least);
    }
    constexpr double kMost = 0x1p300;
    if (most < kMost) return Integer(std::ceil(2 * most)) + 1;
  }
  const HomogeneousPoint crossing = cross(a, b);
  if (crossing[2].is_zero()) return 0;
  return std::max<Integer>(abs(crossing[0]), abs(crossing[1])) / abs(crossing[2]) + 1;
}

PlaneUnion union_of(const Overlay& found, const Integer& frame) {
  PlaneUnion result;
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
  return result;
}

}  // namespace

void PlaneCover::add(const PlaneCell& cell) {
  if (cell.dimension() < 2) {
    thin_.insert(cell);
    return;
  }
  for (const PlaneEdge& edge : cell.edges()) add_border(edge, 1);
  // The two rays of a strip are opposite, and there is nothing in between.
  const std::vector<PlaneDirection>& rays = cell.rays();
  if (rays.size() == 2 && turn(rays[0], rays[1]) > 0) add_arc(rays[0], rays[1]);
  if (rays.size() == 3) {  // a line both ways, and the normal of a half-plane
    add_arc(rays[0], rays[2]);
    add_arc(rays[2], rays[1]);
  }
  if (rays.size() == 4) {
    for (std::size_t k = 0; k < 4; ++k) add_arc(rays[k], rays[(k + 1) % 4]);
  }
}

void PlaneCover::add(const std::vector<PlaneArea>& areas) {
  for (const PlaneArea& area : areas) {
    bool bounded = false;
    for (const Outline& outline : area.outlines) {
      for (const PlaneEdge& edge : outline.edges()) add_border(edge, 1);
      bounded = bounded || (outline.is_closed() && !is_hole(outline));
    }
    if (!bounded) unbounded_.push_back(area);
  }
}

void PlaneCover::add_border(const PlaneEdge& edge, int cells) {
  const bool ordered = edge.from < edge.to;
  const auto found =
      edges_.emplace(ordered ? Ends(edge.from, edge.to) : Ends(edge.to, edge.from), 0).first;
  found->second += ordered ? cells : -cells;
  if (found->second == 0) edges_.erase(found);
}

void PlaneCover::add_arc(const PlaneDirection& from, const PlaneDirection& to) {
  require(turn(from, to) > 0, "an arc goes round less than half a turn");
  arcs_.emplace_back(from, to);
}

bool PlaneCover::is_bounded() const {
  return arcs_.empty() && unbounded_.empty() &&
         std::none_of(edges_.begin(), edges_.end(),
                      [](const auto& edge) {
                        return is_at_infinity(edge.first.first) ||
                               is_at_infinity(edge.first.second);
                      }) &&
         std::all_of(thin_.begin(), thin_.end(),
                     [](const PlaneCell& cell) { return cell.is_bounded(); });
}

/// Returns a direction to the right that no ray goes along.
PlaneDirection PlaneCover::clear_direction() const {
  std::set<PlaneDirection> taken;
  for (const auto& [ends, unused] : edges_) {
    for (const HomogeneousPoint* end : {&ends.first, &ends.second}) {
      if (is_at_infinity(*end)) taken.insert(direction_of(*end));
    }
  }
  for (const auto& [from, to] : arcs_) {
    taken.insert(from);
    taken.insert(to);
  }
  PlaneDirection direction{2, 1};
  while (taken.count(direction) != 0) ++direction[0];
  return direction;
}

int PlaneCover::cells_towards(const PlaneDirection& direction) const {
  return static_cast<int>(std::count_if(arcs_.begin(), arcs_.end(), [&](const auto& arc) {
    return turn(arc.first, direction) > 0 && turn(direction, arc.second) > 0;
  }));
}

/// Returns half the side of the frame, a power of 2. Beyond it rays cross neither one another
/// nor the clear direction from the origin.
Integer PlaneCover::half_side(const PlaneDirection& clear) const {
  Integer most = 1;
  std::set<HomogeneousPoint> lines;
  const auto include = [&](const PlaneEdge& edge) {
    for (const HomogeneousPoint* end : {&edge.from, &edge.to}) {
      if (is_at_infinity(*end)) continue;
      for (const std::size_t j : {0, 1}) {
        most = std::max<Integer>(most, abs((*end)[j]) / (*end)[2] + 1);
      }
    }
    if (is_at_infinity(edge.from) || is_at_infinity(edge.to)) {
      HomogeneousPoint line = primitive(cross(edge.from, edge.to));
      if (negated(line) < line) line = negated(line);
      lines.insert(std::move(line));
    }
  };
  for (const auto& [ends, unused] : edges_) include({ends.first, ends.second});
  for (const PlaneCell& cell : thin_) {
    for (const PlaneEdge& edge : cell.edges()) include(edge);
    for (const PlanePoint& point : cell.vertices())
      include({homogeneous(point), homogeneous(point)});
  }
  include({{0, 0, 1}, homogeneous(clear)});
  std::vector<std::pair<const HomogeneousPoint*, std::array<NearNumber, 3>>> near;
  for (const HomogeneousPoint& line : lines) near.emplace_back(&line, estimates_of(line));
  for (std::size_t a = 0; a < near.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      most = std::max(most, crossing_within(*near[a].first, near[a].second, *near[b].first,
                                            near[b].second));
    }
  }
  return Integer(1) << (msb(most) + 2);
}

PlaneUnion PlaneCover::covered(int least) const {
  const PlaneDirection clear = clear_direction();
  const Integer frame = is_bounded() ? Integer(0) : half_side(clear);
  FramedEdges framed(frame);
  std::vector<FramedEdges::Change> changes;
  for (const auto& [ends, cells] : edges_) {
    framed.add({ends.first, ends.second}, cells);
    const OverlayEdge& edge = framed.edges.back();
    if (is_at_infinity(ends.second)) changes.push_back(framed.change(edge.to, cells));
    if (is_at_infinity(ends.first)) changes.push_back(framed.change(edge.from, -cells));
  }
  if (!frame.is_zero()) {
    const std::size_t start = framed.add_point(exit_of({0, 0, 1}, homogeneous(clear), frame));
    const auto areas =
        std::count_if(unbounded_.begin(), unbounded_.end(), [&](const PlaneArea& area) {
          return PlaneUnion{{area}, {}, {}}.contains(framed.points[start]);
        });
    framed.add_frame(start, cells_towards(clear) + static_cast<int>(areas), std::move(changes));
  }
  std::vector<PlanePoint> points;
  for (const PlaneCell& cell : thin_) {
    for (const PlaneEdge& edge : cell.edges()) framed.add(edge, 0);
    if (cell.dimension() == 0) points.push_back(cell.vertices().front());
  }
  PlaneUnion result;
  if (!framed.edges.empty()) {
    result = union_of(overlay(framed.points, framed.edges, frame, least), frame);
  }
  for (const PlanePoint& point : points) {
    if (!result.contains(point)) result.points.push_back(point);
  }
  return result;
}

}  // namespace stickslip::resistance_detail
