// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "doubles.hpp"
#include "stickslip/arrangement/arrangement_structure.hpp"

namespace stickslip::page_detail {
namespace {

using Motion = std::array<double, 3>;

Motion plus(Motion a, const Motion& b) {
  for (std::size_t j = 0; j < 3; ++j) a[j] += b[j];
  return a;
}

Vector3 rationals(const IntegerVector3& a) {
  return {Rational(a[0]), Rational(a[1]), Rational(a[2])};
}

Motion unit_motion(const IntegerVector3& a) {
  return unit(rationals(a));
}

/// The frame of the grasp's own middle, in units of its size: there the middles of cells are
/// where people see them.
class CellFrame {
 public:
  explicit CellFrame(const Grasp& grasp) {
    if (grasp.size() == 0) return;
    const auto& contacts = grasp.contacts();
    Vector2 low = contacts.front().position;
    Vector2 high = low;
    for (const Contact& c : contacts) {
      low = {std::min(low.x, c.position.x), std::min(low.y, c.position.y)};
      high = {std::max(high.x, c.position.x), std::max(high.y, c.position.y)};
    }
    centre_ = {(low.x + high.x) / 2, (low.y + high.y) / 2};
    const Rational size = std::max(Rational(high.x - low.x), Rational(high.y - low.y)) / 2;
    if (!size.is_zero()) size_ = size;
  }

  Grasp inside(const Grasp& grasp) const {
    std::vector<Contact> contacts = grasp.contacts();
    for (Contact& c : contacts) {
      c.position = {(c.position.x - centre_.x) / size_, (c.position.y - centre_.y) / size_};
    }
    return Grasp(std::move(contacts));
  }

  /// Returns a motion as the body's own frame sees it.
  Json motion_json(const Vector3& d) const {
    return drawn_unit(
        Vector3{size_ * d[0] + d[2] * centre_.y, size_ * d[1] - d[2] * centre_.x, d[2]});
  }
  Json motion_json(const Motion& d) const {
    return motion_json(Vector3{rational_from_double(d[0]), rational_from_double(d[1]),
                               rational_from_double(d[2])});
  }
  Json circle_json(const Vector3& n) const {
    return drawn_unit(Vector3{n[0], n[1], size_ * n[2] - n[0] * centre_.y + n[1] * centre_.x});
  }

 private:
  Vector2 centre_;
  Rational size_{1};
};

class SphereCells {
 public:
  explicit SphereCells(const Grasp& grasp)
      : frame_(grasp), all_(stick_planes(frame_.inside(grasp))) {}

  Json json() const {
    Json circles = Json::array();
    for (const IntegerVector3& normal : all_.circles().normals) {
      circles.push_back(frame_.circle_json(rationals(normal)));
    }
    Json vertices = Json::array();
    for (std::size_t i = 0; i < all_.vertices(); ++i) {
      vertices.push_back(frame_.motion_json(rationals(all_.ray(VertexId(i)))));
    }
    Json cells = Json::array();
    const auto add = [&](const char* kind, const auto& id, Json motion, Json boundary) {
      cells.push_back({{"kind", kind},
                       {"motion", std::move(motion)},
                       {"states", to_string(all_.signs(id))},
                       {"boundary", std::move(boundary)}});
    };
    for (std::size_t i = 0; i < all_.faces(); ++i) {
      auto [middle, boundary] = face(FaceId(i));
      add("face", FaceId(i), frame_.motion_json(middle), std::move(boundary));
    }
    for (std::size_t i = 0; i < all_.edges(); ++i) {
      const HalfedgeId h = ArrangementStructure::first_halfedge(EdgeId(i));
      Json ends = Json::array();
      if (all_.vertices() > 0) ends = {all_.origin(h).index(), all_.target(h).index()};
      add("edge", EdgeId(i), frame_.motion_json(middle_of(h)), std::move(ends));
    }
    for (std::size_t i = 0; i < all_.vertices(); ++i) {
      add("vertex", VertexId(i), vertices[i], Json::array({i}));
    }
    return {{"circles", std::move(circles)},
            {"vertices", std::move(vertices)},
            {"cells", std::move(cells)}};
  }

 private:
  IntegerVector3 left_normal(HalfedgeId halfedge) const {
    const std::size_t circle = all_.circle(ArrangementStructure::edge(halfedge)).index();
    const IntegerVector3& n = all_.circles().normals[circle];
    return all_.sign_to_the_left(halfedge) == Sign::kPositive ? n : negated(n);
  }

  /// Returns a motion between the ends of an edge. The ends may be opposite, and then their sum
  /// is 0.
  Motion middle_of(HalfedgeId halfedge) const {
    const IntegerVector3 normal = left_normal(halfedge);
    if (all_.vertices() == 0) return unit_motion({-normal[1], normal[0], 0});
    const VertexId from = all_.origin(halfedge);
    const VertexId to = all_.target(halfedge);
    if (to == all_.antipode(from)) return unit_motion(cross(normal, all_.ray(from)));
    return plus(unit_motion(all_.ray(from)), unit_motion(all_.ray(to)));
  }

  /// Returns a motion inside of a face, and the face's boundary.
  std::pair<Motion, Json> face(FaceId id) const {
    Json boundary = Json::array();
    const std::optional<HalfedgeId> first = all_.boundary(id);
    if (!first) return {Motion{0, 0, 1}, boundary};
    if (all_.vertices() == 0) return {unit_motion(left_normal(*first)), boundary};
    Motion middle{};
    HalfedgeId h = *first;
    do {
      boundary.push_back(all_.origin(h).index());
      middle = plus(middle, middle_of(h));
      h = all_.next(h);
    } while (h != *first);
    return {middle, boundary};
  }

  CellFrame frame_;
  ArrangementStructure all_;
};

}  // namespace

Json cells_json(const Grasp& grasp) {
  return SphereCells(grasp).json();
}

}  // namespace stickslip::page_detail
