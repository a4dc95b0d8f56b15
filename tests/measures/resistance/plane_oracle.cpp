// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <variant>

#include "stickslip/lp/linear_program.hpp"

namespace stickslip::test {
namespace {

/// Smaller than anything in the worlds of these tests.
const Rational kTiny(1, 100000000);

PlanePoint moved(const PlanePoint& p, const PlaneDirection& d, const Rational& by) {
  return {p[0] + by * Rational(d[0]), p[1] + by * Rational(d[1])};
}

PlaneDirection left_of(const PlaneDirection& d) {
  return {-d[1], d[0]};
}

/// Some point between the ends, where nothing else is in the worlds of these tests.
PlanePoint middle(const PlaneEdge& edge) {
  HomogeneousPoint sum;
  for (std::size_t j = 0; j < 3; ++j) sum[j] = 101 * edge.from[j] + 97 * edge.to[j];
  return point_of(sum);
}

void expect_area(const std::vector<PlaneCell>& cells, const PlaneArea& area) {
  for (const Outline& outline : area.outlines) {
    ASSERT_FALSE(outline.vertices.empty());
    ASSERT_EQ(outline.from.has_value(), outline.to.has_value());
    const std::vector<PlaneEdge> edges = outline.edges();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const PlanePoint at = middle(edges[i]);
      const PlaneDirection d = edges[i].direction();
      EXPECT_TRUE(is_in_some(cells, at));
      EXPECT_TRUE(is_in_some(cells, moved(at, left_of(d), kTiny)));
      EXPECT_FALSE(is_in_some(cells, moved(at, left_of(d), -kTiny)));
      const bool is_line = edges.size() == 2 && !outline.is_closed();
      if (is_line || (i == 0 && !outline.is_closed())) continue;
      EXPECT_NE(edges[(i + edges.size() - 1) % edges.size()].direction(), d) << "not merged";
    }
    if (outline.is_closed()) {
      EXPECT_EQ(outline.vertices.front(),
                *std::min_element(outline.vertices.begin(), outline.vertices.end()));
    }
  }
}

void expect_curve(const std::vector<PlaneCell>& cells, const PlaneUnion& found,
                  const PlaneCell& curve) {
  ASSERT_EQ(curve.dimension(), 1);
  PlaneUnion areas;
  areas.areas = found.areas;
  for (const PlaneEdge& edge : curve.edges()) {
    const PlanePoint at = middle(edge);
    const PlaneDirection d = edge.direction();
    EXPECT_TRUE(is_in_some(cells, at));
    EXPECT_FALSE(areas.contains(at));
    EXPECT_FALSE(is_in_some(cells, moved(at, left_of(d), kTiny)));
    EXPECT_FALSE(is_in_some(cells, moved(at, left_of(d), -kTiny)));
    if (curve.rays().size() == 2) continue;
    if (!is_at_infinity(edge.from)) {
      const PlanePoint end = point_of(edge.from);
      EXPECT_TRUE(areas.contains(end) || !is_in_some(cells, moved(end, d, -kTiny)));
    }
    if (!is_at_infinity(edge.to)) {
      const PlanePoint end = point_of(edge.to);
      EXPECT_TRUE(areas.contains(end) || !is_in_some(cells, moved(end, d, kTiny)));
    }
  }
}

/// Which probes are in the cell; asked once for each cell.
const std::vector<bool>& probes_in(const PlaneCell& cell) {
  static std::map<PlaneCell, std::vector<bool>> known;
  std::vector<bool>& answer = known[cell];
  if (answer.empty()) {
    for (const PlanePoint& p : probes()) answer.push_back(generates(cell.generators(), p));
  }
  return answer;
}

/// All sets of at most `most` of 0..n-1.
void for_each_subset(int n, int most, const std::function<void(const std::vector<int>&)>& use) {
  std::vector<int> chosen;
  const std::function<void(int)> extend = [&](int next) {
    use(chosen);
    if (static_cast<int>(chosen.size()) == most) return;
    for (int i = next; i < n; ++i) {
      chosen.push_back(i);
      extend(i + 1);
      chosen.pop_back();
    }
  };
  extend(0);
}

}  // namespace

bool generates(const Generators& generators, const PlanePoint& p) {
  LinearProgram program;
  program.add_variables(generators.size(), VariableKind::kNonNegative);
  const std::array<Rational, 3> sums{p[0], p[1], 1};
  for (std::size_t j = 0; j < 3; ++j) {
    std::vector<Rational> row;
    for (const HomogeneousPoint& g : generators) row.emplace_back(g[j]);
    program.add_row(std::move(row), Relation::kEqual, sums[j]);
  }
  return std::holds_alternative<Optimal>(solve(program));
}

bool is_in_some(const std::vector<PlaneCell>& cells, const PlanePoint& p) {
  return std::any_of(cells.begin(), cells.end(),
                     [&](const PlaneCell& cell) { return generates(cell.generators(), p); });
}

const std::vector<PlanePoint>& probes() {
  static const std::vector<PlanePoint> all = [] {
    const std::vector<Rational> values{{-3, 2}, -1, {-1, 2}, 0, {1, 3}, 1, {5, 2}};
    std::vector<PlanePoint> points;
    for (const Rational& x : values) {
      for (const Rational& y : values) points.push_back({x, y});
    }
    return points;
  }();
  return all;
}

std::vector<PlaneCell> small_world(int points, int rays) {
  std::vector<HomogeneousPoint> all_points;
  std::vector<HomogeneousPoint> all_rays;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      all_points.push_back({x, y, 1});
      if (x != 0 || y != 0) all_rays.push_back({x, y, 0});
    }
  }
  std::set<PlaneCell> cells;
  for_each_subset(9, points, [&](const std::vector<int>& some_points) {
    if (some_points.empty()) return;
    for_each_subset(8, rays, [&](const std::vector<int>& some_rays) {
      Generators generators;
      for (const int i : some_points)
        generators.push_back(all_points[static_cast<std::size_t>(i)]);
      for (const int i : some_rays) generators.push_back(all_rays[static_cast<std::size_t>(i)]);
      cells.insert(PlaneCell::hull(generators));
    });
  });
  return {cells.begin(), cells.end()};
}

void expect_union(const std::vector<PlaneCell>& cells, const PlaneUnion& found) {
  SCOPED_TRACE(describe(cells) + describe(found));
  for (std::size_t i = 0; i < probes().size(); ++i) {
    const PlanePoint& p = probes()[i];
    const bool inside = std::any_of(cells.begin(), cells.end(),
                                    [&](const PlaneCell& cell) { return probes_in(cell)[i]; });
    EXPECT_EQ(found.contains(p), inside) << p[0] << ", " << p[1];
  }
  for (const PlaneArea& area : found.areas) {
    EXPECT_TRUE(!area.outlines.empty() || found.areas.size() == 1);
    expect_area(cells, area);
  }
  for (const PlaneCell& curve : found.curves) expect_curve(cells, found, curve);
  for (const PlanePoint& p : found.points) {
    EXPECT_TRUE(is_in_some(cells, p));
    for (const PlaneDirection& d : {PlaneDirection{1, 0}, PlaneDirection{0, 1},
                                    PlaneDirection{1, 1}, PlaneDirection{-1, 1}}) {
      EXPECT_FALSE(is_in_some(cells, moved(p, d, kTiny)));
      EXPECT_FALSE(is_in_some(cells, moved(p, d, -kTiny)));
    }
  }
}

std::string describe(const std::vector<PlaneCell>& cells) {
  std::string text;
  for (const PlaneCell& cell : cells) {
    text += "cell";
    for (const PlanePoint& p : cell.vertices())
      text += " (" + to_string(p[0]) + "," + to_string(p[1]) + ")";
    for (const PlaneDirection& d : cell.rays())
      text += " ->(" + d[0].str() + "," + d[1].str() + ")";
    text += '\n';
  }
  return text;
}

std::string describe(const PlaneUnion& region) {
  std::string text;
  for (const PlaneArea& area : region.areas) {
    text += "area\n";
    for (const Outline& outline : area.outlines) {
      text += outline.is_closed() ? "  closed" : "  open";
      if (outline.from)
        text += " ->(" + (*outline.from)[0].str() + "," + (*outline.from)[1].str() + ")";
      for (const PlanePoint& p : outline.vertices)
        text += " (" + to_string(p[0]) + "," + to_string(p[1]) + ")";
      if (outline.to)
        text += " ->(" + (*outline.to)[0].str() + "," + (*outline.to)[1].str() + ")";
      text += '\n';
    }
  }
  text += "curves\n" + describe(region.curves) + "points";
  for (const PlanePoint& p : region.points)
    text += " (" + to_string(p[0]) + "," + to_string(p[1]) + ")";
  return text + '\n';
}

}  // namespace stickslip::test
