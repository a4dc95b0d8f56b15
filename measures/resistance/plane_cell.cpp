// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/plane_cell.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip {

namespace {

PlaneDirection left_normal(const PlaneDirection& d) {
  return {-d[1], d[0]};
}

/// Returns the extreme points of a set of homogeneous points, counterclockwise, by the monotone
/// chain (Andrew 1979) in the affine plane l = 1 for a linear l that is positive on all of
/// them.
std::vector<HomogeneousPoint> convex_hull(const std::vector<HomogeneousPoint>& points,
                                          const HomogeneousPoint& l) {
  std::vector<std::pair<PlanePoint, const HomogeneousPoint*>> sorted;
  for (const HomogeneousPoint& g : points) {
    const Integer scale = dot(l, g);
    sorted.push_back({{Rational(g[0], scale), Rational(g[1], scale)}, &g});
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  sorted.erase(std::unique(sorted.begin(), sorted.end(),
                           [](const auto& a, const auto& b) { return a.first == b.first; }),
               sorted.end());
  std::vector<HomogeneousPoint> hull;
  if (sorted.size() == 1) return {*sorted.front().second};
  for (int pass = 0; pass < 2; ++pass) {  // the lower chain, then the upper one backwards
    const std::size_t base = hull.size();
    for (const auto& [unused, g] : sorted) {
      while (hull.size() >= base + 2 &&
             determinant(hull[hull.size() - 2], hull.back(), *g).sign() <= 0) {
        hull.pop_back();
      }
      hull.push_back(*g);
    }
    hull.pop_back();
    std::reverse(sorted.begin(), sorted.end());
  }
  return hull;
}

}  // namespace

HomogeneousPoint homogeneous(const PlanePoint& point) {
  return primitive_multiple<3>({point[0], point[1], Rational(1)});
}

HomogeneousPoint homogeneous(const PlaneDirection& direction) {
  return primitive<3>({direction[0], direction[1], Integer(0)});
}

PlanePoint point_of(const HomogeneousPoint& g) {
  return {Rational(g[0], g[2]), Rational(g[1], g[2])};
}

PlaneDirection direction_of(const HomogeneousPoint& g) {
  return primitive<2>({g[0], g[1]});
}

int turn(const PlaneDirection& a, const PlaneDirection& b) {
  return Integer(a[0] * b[1] - a[1] * b[0]).sign();
}

Integer determinant(const HomogeneousPoint& a, const HomogeneousPoint& b,
                    const HomogeneousPoint& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

PlaneDirection PlaneEdge::direction() const {
  if (is_at_infinity(from)) return negated(direction_of(from));
  if (is_at_infinity(to)) return direction_of(to);
  return primitive<2>({to[0] * from[2] - from[0] * to[2], to[1] * from[2] - from[1] * to[2]});
}

PlaneCell PlaneCell::hull(std::vector<HomogeneousPoint> generators) {
  std::vector<HomogeneousPoint> points;
  std::vector<PlaneDirection> directions;
  for (HomogeneousPoint& g : generators) {
    require(g[2].sign() >= 0 && !is_zero(g), "a generator is a point or a direction");
    if (is_at_infinity(g)) {
      directions.push_back(direction_of(g));
    } else {
      points.push_back(primitive(std::move(g)));
    }
  }
  require(!points.empty(), "a cell needs a point");
  PlaneCell cell;
  if (directions.empty()) {
    cell.set_without_line(std::move(points), {});
    return cell;
  }
  // left and right: how far the directions go to either side of the first, up to half a turn.
  const PlaneDirection& first = directions.front();
  PlaneDirection left = first;
  PlaneDirection right = first;
  bool has_opposite = false;
  for (const PlaneDirection& d : directions) {
    const int side = turn(first, d);
    if (side == 0) has_opposite = has_opposite || dot(first, d).sign() < 0;
    if (side > 0 && turn(left, d) > 0) left = d;
    if (side < 0 && turn(right, d) < 0) right = d;
  }
  const int opening = turn(right, left);
  if (has_opposite ? left != first && right != first : opening < 0) {
    cell.vertices_ = {{0, 0}};
    cell.rays_ = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    cell.dimension_ = 2;
  } else if (has_opposite && left == right) {
    cell.set_with_line(points, std::max(first, negated(first)), false);
  } else if (has_opposite) {
    cell.set_with_line(points, left != first ? first : negated(first), true);
  } else if (left == right) {
    cell.set_without_line(std::move(points), {first});
  } else if (opening == 0) {
    cell.set_with_line(points, right, true);
  } else {
    cell.set_without_line(std::move(points), {right, left});
  }
  return cell;
}

/// Sets a cell between two borders along the line, or to the left of one.
void PlaneCell::set_with_line(const std::vector<HomogeneousPoint>& points, PlaneDirection line,
                              bool half_plane) {
  const PlaneDirection normal = left_normal(line);
  const auto height = [&](const HomogeneousPoint& g) {
    return Rational(normal[0] * g[0] + normal[1] * g[1], g[2]);
  };
  Rational low = height(points.front());
  Rational high = low;
  for (const HomogeneousPoint& g : points) {
    const Rational value = height(g);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // The vertex of a border is the foot of the perpendicular from the origin.
  const auto add_border = [&](const Rational& at, const PlaneDirection& along, bool as_edge) {
    const Rational scale = at / Rational(dot(normal, normal));
    vertices_.push_back({scale * Rational(normal[0]), scale * Rational(normal[1])});
    if (!as_edge) return;
    const HomogeneousPoint foot = homogeneous(vertices_.back());
    edges_.push_back({homogeneous(negated(along)), foot});
    edges_.push_back({foot, homogeneous(along)});
  };
  add_border(low, line, true);
  rays_ = {line, negated(line)};
  if (half_plane) {
    rays_.push_back(normal);
  } else if (low < high) {
    add_border(high, negated(line), true);
  }
  dimension_ = half_plane || low < high ? 2 : 1;
}

void PlaneCell::set_without_line(std::vector<HomogeneousPoint> points,
                                 std::vector<PlaneDirection> rays) {
  // l is a linear function that is positive on all generators: first on the rays, through x and
  // y, then on the points, through h.
  HomogeneousPoint l{0, 0, 1};
  if (rays.size() == 1) {
    l[0] = rays[0][0];
    l[1] = rays[0][1];
  } else if (rays.size() == 2) {
    l[0] = rays[1][1] - rays[0][1];
    l[1] = rays[0][0] - rays[1][0];
  }
  for (const HomogeneousPoint& g : points) {
    l[2] = std::max<Integer>(l[2], 1 + abs(l[0] * g[0] + l[1] * g[1]));
  }
  for (const PlaneDirection& ray : rays) points.push_back(homogeneous(ray));
  std::vector<HomogeneousPoint> hull = convex_hull(points, l);
  // The outline begins where the border comes from infinity: at the left one of two rays.
  const auto begin =
      rays.empty() ? std::min_element(
                         hull.begin(), hull.end(),
                         [](const auto& a, const auto& b) { return point_of(a) < point_of(b); })
                   : std::find(hull.begin(), hull.end(), homogeneous(rays.back()));
  std::rotate(hull.begin(), begin, hull.end());
  for (const HomogeneousPoint& g : hull) {
    if (!is_at_infinity(g)) vertices_.push_back(point_of(g));
  }
  rays_ = std::move(rays);
  dimension_ = hull.size() >= 3 ? 2 : static_cast<int>(hull.size()) - 1;
  const std::size_t edges =
      dimension_ == 2 ? hull.size() : static_cast<std::size_t>(dimension_);
  for (std::size_t i = 0; i < edges; ++i) {
    const PlaneEdge edge{hull[i], hull[(i + 1) % hull.size()]};
    if (!is_at_infinity(edge.from) || !is_at_infinity(edge.to)) edges_.push_back(edge);
  }
}

std::vector<HomogeneousPoint> PlaneCell::generators() const {
  std::vector<HomogeneousPoint> result;
  for (const PlanePoint& point : vertices_) result.push_back(homogeneous(point));
  for (const PlaneDirection& ray : rays_) result.push_back(homogeneous(ray));
  return result;
}

std::vector<HomogeneousPoint> PlaneCell::sides() const {
  std::vector<HomogeneousPoint> sides;
  const auto add = [&](HomogeneousPoint f) {
    f = primitive(std::move(f));
    if (std::find(sides.begin(), sides.end(), f) == sides.end()) sides.push_back(std::move(f));
  };
  if (dimension_ == 2) {
    for (const PlaneEdge& edge : edges_) add(cross(edge.from, edge.to));
    return sides;
  }
  const auto add_beyond = [&](const PlanePoint& point, const PlaneDirection& d) {
    const HomogeneousPoint a = homogeneous(point);
    add({d[0] * a[2], d[1] * a[2], -(d[0] * a[0] + d[1] * a[1])});
  };
  PlaneDirection along{1, 0};
  if (dimension_ == 1) along = rays_.empty() ? edges_.front().direction() : rays_.front();
  add_beyond(vertices_.front(), left_normal(along));
  add_beyond(vertices_.front(), left_normal(negated(along)));
  if (rays_.size() < 2) add_beyond(vertices_.front(), along);
  if (rays_.empty()) add_beyond(vertices_.back(), negated(along));
  return sides;
}

bool PlaneCell::contains(const PlanePoint& point) const {
  const HomogeneousPoint g = homogeneous(point);
  const std::vector<HomogeneousPoint> all = sides();
  return std::all_of(all.begin(), all.end(),
                     [&](const HomogeneousPoint& f) { return dot(f, g).sign() >= 0; });
}

std::optional<PlaneCell> clip(const PlaneCell& cell, const HomogeneousPoint& f) {
  const std::vector<HomogeneousPoint> generators = cell.generators();
  std::vector<Integer> values;
  for (const HomogeneousPoint& g : generators) values.push_back(dot(f, g));
  std::vector<HomogeneousPoint> kept;
  for (std::size_t a = 0; a < generators.size(); ++a) {
    if (values[a].sign() >= 0) kept.push_back(generators[a]);
    for (std::size_t b = 0; b < generators.size(); ++b) {
      if (values[a].sign() <= 0 || values[b].sign() >= 0) continue;
      HomogeneousPoint between;
      for (std::size_t j = 0; j < 3; ++j) {
        between[j] = values[a] * generators[b][j] - values[b] * generators[a][j];
      }
      if (!is_zero(between)) kept.push_back(std::move(between));
    }
  }
  if (std::all_of(kept.begin(), kept.end(), is_at_infinity)) return std::nullopt;
  return PlaneCell::hull(std::move(kept));
}

std::optional<PlaneCell> clip_to_box(const PlaneCell& cell, const PlanePoint& low,
                                     const PlanePoint& high) {
  std::optional<PlaneCell> result = cell;
  for (std::size_t j = 0; j < 2 && result; ++j) {
    std::array<Rational, 3> above{0, 0, -low[j]};
    std::array<Rational, 3> below{0, 0, high[j]};
    above[j] = 1;
    below[j] = -1;
    result = clip(*result, primitive_multiple(above));
    if (result) result = clip(*result, primitive_multiple(below));
  }
  return result;
}

}  // namespace stickslip
