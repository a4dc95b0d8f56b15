// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/grasp_wrench_space.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "stickslip/core/error.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/engine/cone.hpp"

namespace stickslip {
namespace {

/// The wrenches of a unit normal force with friction on either edge of the cone, their torques
/// divided by `length`.
struct UnitEdges {
  Vector3 plus;
  Vector3 minus;
};

/// Returns the edges by contact. Throws InputError at a normal of irrational length.
std::vector<UnitEdges> unit_edges(const Problem& problem, const Rational& length) {
  require(length.sign() > 0, "the characteristic length must be above 0");
  std::vector<UnitEdges> result;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const Wrench& n = problem.rows()[i].normal;
    const Rational square = n.x * n.x + n.y * n.y;
    const std::optional<Rational> norm = exact_sqrt(square);
    if (!norm) {
      throw InputError("", "contacts[" + std::to_string(i) + "].normal",
                       "a grasp wrench space needs unit normals, and this one has the "
                       "irrational length sqrt(" +
                           to_string(square) + ")",
                       kSnapRemedy);
    }
    const auto edge = [&](int side) {
      const Wrench w = (1 / *norm) * problem.edge_wrench(ContactId(i), side);
      return Vector3{w.x, w.y, w.torque / length};
    };
    result.push_back({edge(1), edge(-1)});
  }
  return result;
}

Rational product(const IntegerVector3& u, const Vector3& x) {
  return Rational(u[0]) * x[0] + Rational(u[1]) * x[1] + Rational(u[2]) * x[2];
}

IntegerVector3 difference(const Vector3& a, const Vector3& b) {
  return primitive_multiple<3>({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

/// Returns the facets: they are the extreme rays of the polar {(u, h) : u.p <= h for all points
/// p of the space}. Cone starts as h >= 0, which is the condition of the point 0.
std::vector<HalfSpace> l1_facets(const std::vector<UnitEdges>& edges) {
  Cone polar;
  for (const UnitEdges& e : edges) {
    for (const Vector3& p : {e.plus, e.minus}) {
      polar.cut(primitive_multiple<5>({-p[0], -p[1], -p[2], 1, 0}), Side::kPositive);
    }
  }
  if (!polar.lines().empty()) {
    // A line has h = 0, since h >= 0 both ways.
    const IntegerVector5& line = polar.lines().front();
    const IntegerVector3 u{line[0], line[1], line[2]};
    return {{u, 0}, {negated(u), 0}};
  }
  std::vector<HalfSpace> facets;
  for (const Ray& ray : polar.rays()) {
    const IntegerVector3 u{ray.x[0], ray.x[1], ray.x[2]};
    const IntegerVector3 normal = primitive(u);
    const std::size_t j = u[0].is_zero() ? (u[1].is_zero() ? 2 : 1) : 0;
    facets.push_back({normal, Rational(ray.x[3]) * Rational(normal[j]) / Rational(u[j])});
  }
  return facets;
}

/// The support of the Minkowski sum in the direction u: h(u) = max u.x, and the edges of
/// triangles on which the maximum is attained.
struct Support {
  Rational offset = 0;
  std::vector<IntegerVector3> edges;

  Support(const IntegerVector3& u, const std::vector<UnitEdges>& triangles) {
    for (const UnitEdges& e : triangles) {
      const std::array<Vector3, 3> corners{Vector3{0, 0, 0}, e.plus, e.minus};
      std::array<Rational, 3> heights;
      for (std::size_t k = 0; k < 3; ++k) heights[k] = product(u, corners[k]);
      const Rational top = *std::max_element(heights.begin(), heights.end());
      offset += top;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (heights[k] != top || heights[next] != top) continue;
        // Two corners are one without friction.
        const IntegerVector3 edge = difference(corners[next], corners[k]);
        if (!is_zero(edge)) edges.push_back(edge);
      }
    }
  }

  /// Returns true if two edges are independent.
  bool is_facet() const {
    return std::any_of(edges.begin(), edges.end(), [&](const IntegerVector3& edge) {
      return !is_zero(cross(edges.front(), edge));
    });
  }
};

std::vector<HalfSpace> linf_facets(const std::vector<UnitEdges>& triangles) {
  // Directions are listed up to sign, without repetition.
  std::set<IntegerVector3> directions;
  for (const UnitEdges& e : triangles) {
    for (IntegerVector3 edge :
         {difference(e.plus, {}), difference(e.minus, {}), difference(e.plus, e.minus)}) {
      if (!is_zero(edge) && directions.count(negated(edge)) == 0) directions.insert(edge);
    }
  }
  std::set<IntegerVector3> normals;
  for (auto a = directions.begin(); a != directions.end(); ++a) {
    for (auto b = std::next(a); b != directions.end(); ++b) {
      const IntegerVector3 u = primitive(cross(*a, *b));
      normals.insert(u);
      normals.insert(negated(u));
    }
  }
  std::vector<HalfSpace> facets;
  for (const IntegerVector3& u : normals) {
    const Support support(u, triangles);
    if (support.is_facet()) facets.push_back({u, support.offset});
  }
  if (!facets.empty()) return facets;
  // There is at most one direction: the space is a segment or a point.
  IntegerVector3 u{0, 0, 1};
  if (!directions.empty()) {
    u = primitive(cross(*directions.begin(), u));
    if (is_zero(u)) u = {1, 0, 0};
  }
  return {{u, 0}, {negated(u), 0}};
}

}  // namespace

std::vector<HalfSpace> wrench_space_facets(const Problem& problem, ForceBound bound,
                                           const Rational& length) {
  const std::vector<UnitEdges> edges = unit_edges(problem, length);
  std::vector<HalfSpace> facets =
      bound == ForceBound::kL1 ? l1_facets(edges) : linf_facets(edges);
  for (const HalfSpace& facet : facets) {
    require(!is_zero(facet.normal) && facet.offset.sign() >= 0, "a facet does not hold 0");
    // The reach is the sum over all contacts, or the best of them.
    Rational reach = 0;
    for (const UnitEdges& e : edges) {
      const Rational here = std::max(
          {Rational(0), product(facet.normal, e.plus), product(facet.normal, e.minus)});
      reach = bound == ForceBound::kL1 ? std::max(reach, here) : Rational(reach + here);
    }
    require(reach == facet.offset, "a facet does not support the grasp wrench space");
  }
  std::sort(facets.begin(), facets.end(),
            [](const HalfSpace& a, const HalfSpace& b) { return a.normal < b.normal; });
  return facets;
}

GraspQuality ferrari_canny_quality(const std::vector<HalfSpace>& facets) {
  require(!facets.empty(), "a quality needs at least one facet");
  const auto distance_squared = [](const HalfSpace& f) {
    return Rational(f.offset * f.offset / Rational(dot(f.normal, f.normal)));
  };
  GraspQuality best{distance_squared(facets.front()), facets.front()};
  for (const HalfSpace& facet : facets) {
    const Rational squared = distance_squared(facet);
    if (squared < best.radius_squared) best = {squared, facet};
  }
  return best;
}

namespace {

/// Returns a positive number if a, b, c turn left.
Rational turn(const Vector2& a, const Vector2& b, const Vector2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Returns the hull by Andrew's monotone chain (Inf. Proc. Letters 9(5), 1979).
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
