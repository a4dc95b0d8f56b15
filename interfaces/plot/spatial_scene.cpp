// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip::plot_detail {
namespace {

InkVector in_length_1(const Vector3& v) {
  const InkVector near = over_size(v, size_of(v));
  return sum({}, 1 / std::sqrt(stickslip::dot(near, near)), near);
}

/// Returns rings that wind around all faces counterclockwise, and around nothing else. They are
/// those edges of the faces, each run counterclockwise as it is seen, that no other face runs
/// back along.
std::vector<std::vector<InkPoint>> boundary(
    const std::vector<InkPoint>& vertices, const std::vector<std::vector<std::size_t>>& faces) {
  std::map<std::pair<std::size_t, std::size_t>, int>
      runs;  // the runs of each edge, one way less the other
  for (const std::vector<std::size_t>& face : faces) {
    double area = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const InkPoint& a = vertices[face[k]];
      const InkPoint& b = vertices[face[(k + 1) % face.size()]];
      area += a.x * b.y - a.y * b.x;
    }
    for (std::size_t k = 0; k < face.size() && area != 0; ++k) {
      const std::size_t a = face[k];
      const std::size_t b = face[(k + 1) % face.size()];
      if (a != b) runs[std::minmax(a, b)] += (a < b) == (area > 0) ? 1 : -1;
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> next;
  for (const auto& [edge, times] : runs) {
    const auto [from, to] = times > 0 ? edge : std::pair(edge.second, edge.first);
    next[from].insert(next[from].end(), static_cast<std::size_t>(std::abs(times)), to);
  }
  // Each way ends where it began, as equally many edges end at a vertex and begin there.
  std::vector<std::vector<InkPoint>> rings;
  for (auto& [start, ends] : next) {
    while (!ends.empty()) {
      std::vector<InkPoint>& ring = rings.emplace_back();
      std::size_t at = start;
      do {
        ring.push_back(vertices[at]);
        std::vector<std::size_t>& ways = next.at(at);
        at = ways.back();
        ways.pop_back();
      } while (at != start);
    }
  }
  return rings;
}

/// Adds two directions orthogonal to the normal, one of them in a coordinate plane.
void add_tangents(SpatialContactInk& c) {
  const InkVector& n = c.normal;
  const auto least = static_cast<std::size_t>(
      std::min_element(n.begin(), n.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      n.begin());
  InkVector axis{};
  axis[least] = 1;
  c.across = sum(axis, -n[least], n);
  c.across = sum({}, 1 / std::sqrt(stickslip::dot(c.across, c.across)), c.across);
  c.along = stickslip::cross(n, c.across);
}

}  // namespace

InkVector sum(InkVector a, double factor, const InkVector& b) {
  for (std::size_t j = 0; j < 3; ++j) a[j] += factor * b[j];
  return a;
}

Rational size_of(const Vector3& v) {
  return std::max({Rational(abs(v[0])), Rational(abs(v[1])), Rational(abs(v[2]))});
}

InkVector over_size(const Vector3& v, const Rational& size) {
  return {to_double(v[0] / size), to_double(v[1] / size), to_double(v[2] / size)};
}

std::vector<LineOfSight> sides_of(bool in_space) {
  if (!in_space) return {{"", 0, 1, 2, 1}};
  return {{"from above: x right, y up", 0, 1, 2, 1},
          {"from the front: x right, z up", 0, 2, 1, -1},
          {"from the right: y right, z up", 1, 2, 0, 1}};
}

SpatialContactInk spatial_contact_ink(const Vector3& position, const InkVector& at,
                                      const Vector3& normal) {
  SpatialContactInk contact{position, at, in_length_1(normal), {}, {}};
  add_tangents(contact);
  return contact;
}

std::vector<InkVector> cone_around(const SpatialContactInk& c, double half_angle, double size) {
  constexpr int kTurns = 48;
  constexpr int kSteps = 8;
  std::vector<InkVector> points{c.at, sum(c.at, size, c.normal)};
  for (int turn = 0; turn < kTurns; ++turn) {
    const double around = 2 * M_PI * turn / kTurns;
    const InkVector tangent =
        sum(sum({}, std::cos(around), c.across), std::sin(around), c.along);
    for (int step = 1; step <= kSteps; ++step) {
      const double angle = half_angle * step / kSteps;
      points.push_back(
          sum(sum(c.at, size * std::cos(angle), c.normal), size * std::sin(angle), tangent));
    }
  }
  return points;
}

std::vector<InkPoint> hull_seen(const LineOfSight& side, const std::vector<InkVector>& points) {
  std::vector<InkPoint> seen;
  for (const InkVector& p : points) seen.push_back(side(p));
  return convex_hull(std::move(seen));
}

std::vector<std::vector<InkPoint>> Shape::seen(const LineOfSight& side) const {
  if (points.empty()) return {};
  if (kind == Kind::kHull) return {hull_seen(side, points)};
  std::vector<InkPoint> vertices;
  for (const InkVector& p : points) vertices.push_back(side(p));
  if (kind == Kind::kFaces) return boundary(vertices, parts);
  std::vector<std::vector<InkPoint>> rings;
  for (const std::vector<std::size_t>& part : parts) {
    rings.emplace_back();
    for (const std::size_t k : part) rings.back().push_back(vertices[k]);
  }
  return rings;
}

InkVector Shape::middle() const {
  InkVector mean{};
  for (const InkVector& p : points) mean = sum(mean, 1 / static_cast<double>(points.size()), p);
  return mean;
}

Shape sketch(const std::vector<SpatialContactInk>& contacts, bool in_space) {
  Shape shape;
  for (const SpatialContactInk& c : contacts) shape.points.push_back(c.at);
  const auto is_in_front = [](const InkVector& p, const SpatialContactInk& c) {
    return stickslip::dot(sum(p, -1, c.at), c.normal) >= 0;
  };
  for (const SpatialContactInk& c : contacts) {
    for (const InkVector* tangent : {&c.across, &c.along}) {
      // One of the tangents of the plane leads out of it.
      if (!in_space && std::abs((*tangent)[2]) > 0.5) continue;
      for (const double side : {-0.3, 0.3, -0.4, 0.4}) {
        const double inwards = std::abs(side) < 0.35 ? 0.12 : 0.5;
        const InkVector p = sum(sum(c.at, inwards, c.normal), side, *tangent);
        if (std::all_of(contacts.begin(), contacts.end(), [&](const SpatialContactInk& other) {
              return is_in_front(p, other);
            })) {
          shape.points.push_back(p);
        }
      }
    }
  }
  return shape;
}

Shape sketch_of_link(const std::vector<InkVector>& points, bool in_space) {
  constexpr double kAround = 0.06;
  Shape shape;
  for (const InkVector& p : points) {
    for (int corner = 0; corner < (in_space ? 8 : 4); ++corner) {
      InkVector at = p;
      for (std::size_t j = 0; j < (in_space ? 3U : 2U); ++j) {
        at[j] += (corner >> j & 1) != 0 ? kAround : -kAround;
      }
      shape.points.push_back(at);
    }
  }
  return shape;
}

}  // namespace stickslip::plot_detail
