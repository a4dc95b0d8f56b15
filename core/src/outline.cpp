// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/outline.hpp"

#include <optional>
#include <string>

#include "simple_polygon.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {

using namespace core_detail;

namespace {

const Vector2& next(const Ring& ring, std::size_t i) {
  return ring[i + 1 == ring.size() ? 0 : i + 1];
}

/// Returns twice the area of a ring, positive if it runs counterclockwise.
Rational doubled_area(const Ring& ring) {
  Rational area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2& to = next(ring, i);
    area += ring[i].x * to.y - ring[i].y * to.x;
  }
  return area;
}

void check_ring(const Ring& ring, const std::string& path) {
  if (ring.size() < 3) {
    fail_at(path, "found a ring of " + std::to_string(ring.size()) + " vertices",
            "give at least three, [[x, y], ...]");
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!(ring[i] == next(ring, i))) continue;
    const bool last = i + 1 == ring.size();
    fail_at(element_path(path, i),
            std::string("the vertex is the same as the ") + (last ? "first" : "next"),
            last ? "leave it out: a ring closes by itself" : "leave one of them out");
  }
  if (doubled_area(ring).is_zero()) {
    fail_at(path, "the ring has no area", "give its vertices in their order around the body");
  }
}

}  // namespace

Vector2 OutlineEdge::at(const Rational& share) const {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

void check_outline(const std::vector<Polygon>& outline) {
  for (std::size_t j = 0; j < outline.size(); ++j) {
    const std::string path = element_path("outline", j);
    if (outline[j].empty()) {
      fail_at(path, "found a polygon without a ring", "give its outer ring, [[[x, y], ...]]");
    }
    for (std::size_t k = 0; k < outline[j].size(); ++k) {
      check_ring(outline[j][k], element_path(path, k));
    }
    check_simple(outline[j], path);
  }
}

std::vector<std::vector<OutlineEdge>> outline_edges(const std::vector<Polygon>& outline) {
  std::vector<std::vector<OutlineEdge>> edges;
  for (const Polygon& polygon : outline) {
    edges.emplace_back();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Ring& ring = polygon[k];
      // The body is to the left of a ring that runs counterclockwise, unless it is a hole's.
      const int side = doubled_area(ring).sign() * (k == 0 ? 1 : -1);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vector2& from = ring[i];
        const Vector2& to = next(ring, i);
        Vector2 inwards{side * (from.y - to.y), side * (to.x - from.x)};
        if (const auto length = exact_sqrt(inwards.x * inwards.x + inwards.y * inwards.y)) {
          inwards = {inwards.x / *length, inwards.y / *length};
        }
        edges.back().push_back({from, to, inwards});
      }
    }
  }
  return edges;
}

}  // namespace stickslip
