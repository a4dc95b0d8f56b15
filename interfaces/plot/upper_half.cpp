// SPDX-License-Identifier: GPL-3.0-or-later
//
// A circle with the normal N is passed in the direction N x d at d. It rises above the rim at
// e1 = z x N = (-N_y, N_x, 0) and then goes towards e2 = N x e1.
#include "upper_half.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip::plot_detail {
namespace {

constexpr double kStep = M_PI / 90;  ///< largest angle between neighbouring points of a curve

IntegerVector3 rising_point(const IntegerVector3& normal) {
  return {-normal[1], normal[0], 0};
}

SpherePoint to_sphere(const IntegerVector3& v) {
  Integer largest = 0;
  for (const Integer& entry : v) largest = std::max(largest, Integer(abs(entry)));
  SpherePoint p{};
  for (std::size_t j = 0; j < 3; ++j) p[j] = to_double(Rational(v[j], largest));
  const double size = std::hypot(p[0], p[1], p[2]);
  for (double& entry : p) entry /= size;
  return p;
}

/// The visible half of a circle.
struct Track {
  SpherePoint e1, e2;

  explicit Track(const IntegerVector3& normal) : e1(to_sphere(rising_point(normal))) {
    e2 = to_sphere(stickslip::cross(normal, rising_point(normal)));
  }
  SpherePoint at(double angle) const {
    SpherePoint p{};
    for (std::size_t j = 0; j < 3; ++j) {
      p[j] = std::cos(angle) * e1[j] + std::sin(angle) * e2[j];
    }
    return p;
  }
  double angle(const SpherePoint& p) const {
    const auto dot = [&](const SpherePoint& a) {
      return a[0] * p[0] + a[1] * p[1] + a[2] * p[2];
    };
    // Visible points are not below the rim, whatever rounding says.
    return std::atan2(std::max(0.0, dot(e2)), dot(e1));
  }
};

template <class PointAt>
void sample(double begin, double end, const PointAt& at, std::vector<SpherePoint>& points) {
  const int steps = std::max(1, static_cast<int>(std::ceil((end - begin) / kStep)));
  for (int i = 0; i <= steps; ++i) points.push_back(at(begin + (end - begin) * i / steps));
}

/// Adds points along the rim, counterclockwise.
void sample_rim(const SpherePoint& from, const SpherePoint& to,
                std::vector<SpherePoint>& points) {
  const double begin = std::atan2(from[1], from[0]);
  double turn = std::atan2(to[1], to[0]) - begin;
  if (turn < 0) turn += 2 * M_PI;
  // A visible part of a face has at most half of the rim.
  if (turn > 1.5 * M_PI) return;
  sample(
      begin, begin + turn,
      [](double angle) {
        return SpherePoint{std::cos(angle), std::sin(angle), 0};
      },
      points);
}

}  // namespace

InkPoint project(const SpherePoint& p) {
  return 1 / std::sqrt(1 + p[2]) * InkPoint{-p[1], p[0]};
}

UpperHalf::UpperHalf(const ArrangementStructure& cells) : cells_(cells) {
  for (std::size_t i = 0; i < cells.vertices(); ++i) {
    vertices_.push_back(cells.ray(VertexId(i)));
  }
}

IntegerVector3 UpperHalf::normal(HalfedgeId halfedge) const {
  const std::size_t circle = cells_.circle(ArrangementStructure::edge(halfedge)).index();
  const IntegerVector3& n = cells_.circles().normals[circle];
  return cells_.sign_to_the_left(halfedge) == Sign::kPositive ? n : negated(n);
}

SpherePoint UpperHalf::place(VertexId vertex) const {
  return to_sphere(vertices_[vertex.index()]);
}

SpherePoint UpperHalf::on_circle(CircleId circle, double angle) const {
  return Track(cells_.circles().normals[circle.index()]).at(angle);
}

UpperHalf::Span UpperHalf::span(HalfedgeId halfedge) const {
  if (cells_.vertices() == 0) return {true, 0, M_PI, false};
  const IntegerVector3 n = normal(halfedge);
  const VertexId a = cells_.origin(halfedge);
  const VertexId b = cells_.target(halfedge);
  const Track track(n);
  // An edge is no longer than half a circle. So at most one of its ends is cut off, and it
  // comes back to neither side of the rim.
  const bool rises_at_a = height(a) == Sign::kZero &&
                          stickslip::dot(vertices_[a.index()], rising_point(n)).sign() > 0;
  const bool rises = height(a) == Sign::kNegative && height(b) == Sign::kPositive;
  if (height(a) != Sign::kPositive && !rises_at_a && !rises) return {};
  Span span;
  span.is_visible = true;
  span.begin = height(a) == Sign::kPositive ? track.angle(place(a)) : 0;
  span.end = height(b) == Sign::kPositive ? track.angle(place(b)) : M_PI;
  span.ends_at_vertex = height(b) != Sign::kNegative;
  return span;
}

std::vector<SpherePoint> UpperHalf::edge(EdgeId edge) const {
  const HalfedgeId h = ArrangementStructure::first_halfedge(edge);
  const Span s = span(h);
  std::vector<SpherePoint> points;
  if (!s.is_visible) return points;
  const Track track(normal(h));
  sample(
      s.begin, s.end, [&](double angle) { return track.at(angle); }, points);
  return points;
}

std::vector<SpherePoint> UpperHalf::face(FaceId face) const {
  std::vector<SpherePoint> points;
  const std::optional<HalfedgeId> first = cells_.boundary(face);
  if (!first) {
    sample_rim({1, 0, 0}, {-1, 0, 0}, points);
    sample_rim({-1, 0, 0}, {1, 0, 0}, points);
    return points;
  }
  HalfedgeId h = *first;
  do {
    const Span s = span(h);
    if (s.is_visible) {
      const Track track(normal(h));
      sample(
          s.begin, s.end, [&](double angle) { return track.at(angle); }, points);
      HalfedgeId next = cells_.next(h);
      const bool goes_on = s.ends_at_vertex && span(next).is_visible;
      if (!goes_on) {
        // The way goes along the rim to where the border rises again.
        while (!span(next).is_visible) next = cells_.next(next);
        sample_rim(track.at(M_PI), Track(normal(next)).e1, points);
      }
    }
    h = cells_.next(h);
  } while (h != *first);
  return points;
}

}  // namespace stickslip::plot_detail
