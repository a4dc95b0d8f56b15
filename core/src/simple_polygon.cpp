// SPDX-License-Identifier: GPL-3.0-or-later
#include "simple_polygon.hpp"

#include <algorithm>

#include "stickslip/core/json.hpp"

namespace stickslip::core_detail {
namespace {

struct RingEdge {
  const Vector2* from;
  const Vector2* to;
  std::size_t number;    ///< its number in the polygon
  std::size_t previous;  ///< the number of its neighbour before it
  std::size_t next;

  const Rational& low_x() const { return std::min(from->x, to->x); }
  const Rational& high_x() const { return std::max(from->x, to->x); }
  const Rational& low_y() const { return std::min(from->y, to->y); }
  const Rational& high_y() const { return std::max(from->y, to->y); }
};

std::vector<RingEdge> sides_of(const Polygon& polygon) {
  std::vector<RingEdge> sides;
  for (const Ring& ring : polygon) {
    const std::size_t first = sides.size();
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      sides.push_back({&ring[i], &ring[(i + 1) % n], first + i, first + (i + n - 1) % n,
                       first + (i + 1) % n});
    }
  }
  return sides;
}

/// Returns the side of the line from a to b on which p is: + on the left.
int side_of(const Vector2& a, const Vector2& b, const Vector2& p) {
  return Rational((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)).sign();
}

bool ranges_overlap(const RingEdge& a, const RingEdge& b) {
  return a.low_x() <= b.high_x() && b.low_x() <= a.high_x() && a.low_y() <= b.high_y() &&
         b.low_y() <= a.high_y();
}

/// Returns whether `next`, which begins where `side` ends, goes back along it.
bool turns_back(const RingEdge& side, const RingEdge& next) {
  const Vector2& a = *side.from;
  const Vector2& b = *side.to;
  const Vector2& c = *next.to;
  return side_of(a, b, c) == 0 &&
         Rational((b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y)).sign() < 0;
}

/// Returns whether two edges meet in more than the common end of neighbours. Requires that
/// their ranges overlap.
bool meet(const RingEdge& a, const RingEdge& b) {
  if (a.next == b.number) return turns_back(a, b);
  if (b.next == a.number) return turns_back(b, a);
  // They meet if neither lies on one side of the other's line. If both are on one line, their
  // ranges decide.
  return side_of(*a.from, *a.to, *b.from) * side_of(*a.from, *a.to, *b.to) <= 0 &&
         side_of(*b.from, *b.to, *a.from) * side_of(*b.from, *b.to, *a.to) <= 0;
}

/// Returns whether a point is inside the ring. Requires that it is on no edge of the ring.
bool is_inside(const Vector2& p, const Ring& ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2& a = ring[i];
    const Vector2& b = ring[(i + 1) % ring.size()];
    const bool up = a.y <= p.y && b.y > p.y;
    const bool down = b.y <= p.y && a.y > p.y;
    if ((up && side_of(a, b, p) > 0) || (down && side_of(a, b, p) < 0)) inside = !inside;
  }
  return inside;
}

}  // namespace

void check_simple(const Polygon& polygon, const std::string& path) {
  std::vector<RingEdge> sides = sides_of(polygon);
  std::sort(sides.begin(), sides.end(),
            [](const RingEdge& a, const RingEdge& b) { return a.low_x() < b.low_x(); });
  for (auto a = sides.begin(); a != sides.end(); ++a) {
    for (auto b = a + 1; b != sides.end() && b->low_x() <= a->high_x(); ++b) {
      if (!ranges_overlap(*a, *b) || !meet(*a, *b)) continue;
      const auto [first, second] = std::minmax(a->number, b->number);
      fail_at(
          path,
          "its edges " + std::to_string(first) + " and " + std::to_string(second) + " meet",
          "give the vertices in their order around the body; rings neither cross nor touch");
    }
  }
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    for (std::size_t other = 0; other < polygon.size(); ++other) {
      if (other == k || is_inside(polygon[k].front(), polygon[other]) == (other == 0)) continue;
      fail_at(element_path(path, k),
              other == 0 ? "the hole is not inside the outer ring"
                         : "the hole is inside another one, ring " + std::to_string(other),
              "a polygon is its outer ring and then its holes; other parts of the body are "
              "polygons of their own");
    }
  }
}

}  // namespace stickslip::core_detail
