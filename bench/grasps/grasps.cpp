// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasps.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "random_source.hpp"

namespace stickslip::bench {
namespace {

constexpr int kGridSteps = 1000;

bool is_upper(const Vector2& v) {
  return v.y.sign() > 0 || (v.y.is_zero() && v.x.sign() > 0);
}

/// By angle in [0, 2 pi), exactly.
bool comes_before(const Vector2& a, const Vector2& b) {
  if (is_upper(a) != is_upper(b)) return is_upper(a);
  return (a.x * b.y - a.y * b.x).sign() > 0;
}

std::vector<Vector2> make_unit_directions() {
  const std::vector<Vector2> quarters{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const auto powers = [](const Vector2& u) {
    const Vector2 back{u.x, -u.y};
    return std::vector<Vector2>{rotated(back, back), back, {1, 0}, u, rotated(u, u)};
  };
  std::vector<Vector2> result;
  for (const Vector2& a : quarters) {
    for (const Vector2& b : powers({Rational(3, 5), Rational(4, 5)})) {
      for (const Vector2& c : powers({Rational(5, 13), Rational(12, 13)})) {
        result.push_back(rotated(rotated(a, b), c));
      }
    }
  }
  std::sort(result.begin(), result.end(), comes_before);
  return result;
}

Vector2 on_grid(const Vector2& p) {
  return {floor_to_grid(p.x, kGridSteps), floor_to_grid(p.y, kGridSteps)};
}

/// Friction, stiffness, preload.
Contact material(RandomSource& random, bool preloaded) {
  Contact c;
  c.friction = Rational(random.between(2, 9), 10);
  c.stiffness = random.between(1, 5);
  c.preload = preloaded ? Rational(random.between(1, 8), 4) : Rational(0);
  return c;
}

/// The contact on the boundary with this normal: at -2 n, moved along the edge and, a little,
/// across it.
Vector2 boundary_point(RandomSource& random, const Vector2& n) {
  const Rational along(random.between(-60, 60), kGridSteps);
  const Rational out = 2 + Rational(random.between(-200, 200), kGridSteps);
  return on_grid({-out * n.x - along * n.y, -out * n.y + along * n.x});
}

std::vector<Contact> on_boundary(RandomSource& random, std::size_t contacts, bool preloaded,
                                 const std::vector<Vector2>& normals) {
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts; ++i) {
    Contact c = material(random, preloaded);
    c.normal = normals[i * normals.size() / contacts];
    c.position = boundary_point(random, c.normal);
    result.push_back(std::move(c));
  }
  return result;
}

/// Between `low` and `high` percent, with a denominator of three to seven digits, as likely
/// each.
Rational varied(RandomSource& random, int low, int high) {
  int least = 100;
  for (int digits = random.between(0, 4); digits > 0; --digits) least *= 10;
  const int denominator = random.between(least, 10 * least - 1);
  const auto percent_of = [denominator](int percent) {
    return static_cast<int>(std::int64_t{denominator} * percent / 100);
  };
  return Rational(random.between(percent_of(low) + 1, percent_of(high))) / denominator;
}

/// A unit vector of the quarter that `quarter` begins, `share` percent of it on: the rational
/// point (1 - t^2, 2 t) / (1 + t^2) of the circle.
Vector2 varied_unit_vector(RandomSource& random, const Vector2& quarter, int share) {
  const int denominator = random.between(20, 2000);
  const Rational t(denominator * share / 100, denominator);
  const Rational scale = 1 + t * t;
  return rotated(quarter, {(1 - t * t) / scale, 2 * t / scale});
}

std::vector<Contact> on_varied_boundary(RandomSource& random, std::size_t contacts,
                                        bool preloaded) {
  const std::vector<Vector2> quarters{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts; ++i) {
    Contact c;
    c.friction = varied(random, 20, 90);
    c.stiffness = varied(random, 100, 500);
    c.preload = preloaded ? varied(random, 25, 200) : Rational(0);
    const std::size_t turns = i * quarters.size();
    c.normal = varied_unit_vector(random, quarters[turns / contacts],
                                  static_cast<int>(turns % contacts * 100 / contacts));
    c.position = boundary_point(random, c.normal);
    result.push_back(std::move(c));
  }
  return result;
}

std::vector<Vector2> arc_normals() {
  // 40 of the 100 directions around (0, 1).
  const std::vector<Vector2>& all = unit_directions();
  const auto up = std::find(all.begin(), all.end(), Vector2{0, 1});
  return {up - 20, up + 20};
}

std::vector<Contact> on_edges(RandomSource& random, std::size_t contacts, bool preloaded) {
  // A floor and two walls that lean outwards (between parallel walls friction alone holds any
  // pull), the body turned a little.
  struct Edge {
    Vector2 foot;
    Vector2 normal;
  };
  const Vector2 turn{Rational(24, 25), Rational(7, 25)};
  const std::vector<Edge> edges{{{0, -1}, {0, 1}},
                                {{Rational(-3, 2), 0}, {Rational(12, 13), Rational(5, 13)}},
                                {{Rational(3, 2), 0}, {Rational(-12, 13), Rational(5, 13)}}};
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts; ++i) {
    Contact c = material(random, preloaded);
    const Edge& edge = edges[i % edges.size()];
    const Rational along(random.between(-900, 900), kGridSteps);
    const Vector2 p{edge.foot.x - along * edge.normal.y, edge.foot.y + along * edge.normal.x};
    // Positions are exact, or the contacts would not share their edge's circle.
    c.position = rotated(p, turn);
    c.normal = rotated(edge.normal, turn);
    result.push_back(std::move(c));
  }
  return result;
}

std::vector<Contact> on_grid_points(RandomSource& random, std::size_t contacts,
                                    bool preloaded) {
  int side = 1;
  while (static_cast<std::size_t>(side) * static_cast<std::size_t>(side) < contacts) ++side;
  const std::vector<Vector2> normals{{0, 1},
                                     {1, 0},
                                     {-1, 0},
                                     {Rational(3, 5), Rational(4, 5)},
                                     {Rational(-3, 5), Rational(4, 5)}};
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts; ++i) {
    Contact c = material(random, preloaded);
    const int index = static_cast<int>(i);
    // 3 across, whatever the size.
    c.position = {Rational(3 * (index % side), side) - Rational(3, 2),
                  Rational(3 * (index / side), side) - Rational(3, 2)};
    c.normal = normals[i < normals.size() ? i : static_cast<std::size_t>(random.between(0, 4))];
    result.push_back(std::move(c));
  }
  return result;
}

std::vector<Contact> on_jaws(RandomSource& random, std::size_t pairs, bool preloaded) {
  std::vector<Contact> result;
  for (std::size_t i = 0; i < pairs; ++i) {
    Contact left = material(random, preloaded);
    left.friction = Rational(1, 2);
    left.position = {-1, Rational(random.between(-2000, 2000), kGridSteps)};
    left.normal = {1, 0};
    Contact right = left;
    right.position.x = 1;
    right.normal = {-1, 0};
    result.push_back(std::move(left));
    result.push_back(std::move(right));
  }
  return result;
}

std::vector<Contact> on_disc(RandomSource& random, std::size_t pairs, bool preloaded) {
  const std::vector<Vector2>& all = unit_directions();
  const std::vector<Vector2> half(all.begin(), all.begin() + 50);
  std::vector<Contact> result;
  for (std::size_t i = 0; i < pairs; ++i) {
    Contact c = material(random, preloaded);
    c.friction = Rational(1, 2);
    c.normal = half[i * half.size() / pairs];
    c.position = {-2 * c.normal.x, -2 * c.normal.y};
    Contact opposite = c;
    opposite.normal = {-c.normal.x, -c.normal.y};
    opposite.position = {-c.position.x, -c.position.y};
    result.push_back(std::move(c));
    result.push_back(std::move(opposite));
  }
  return result;
}

}  // namespace

Vector2 rotated(const Vector2& v, const Vector2& by) {
  return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x};
}

Rational floor_to_grid(const Rational& value, int steps) {
  const Rational scaled = value * steps;
  Integer quotient = numerator(scaled) / denominator(scaled);  // towards 0
  if (scaled.sign() < 0 && Rational(quotient) != scaled) quotient -= 1;
  return Rational(quotient) / steps;
}

const std::vector<Vector2>& unit_directions() {
  static const std::vector<Vector2> directions = make_unit_directions();
  return directions;
}

const char* name_of(Layout layout) {
  switch (layout) {
    case Layout::kRound:
      return "round";
    case Layout::kArc:
      return "arc";
    case Layout::kEdges:
      return "edges";
    case Layout::kGrid:
      return "grid";
    case Layout::kJaws:
      return "jaws";
    case Layout::kDisc:
      return "disc";
    case Layout::kVaried:
      return "varied";
  }
  return "?";
}

Grasp make_grasp(Layout layout, std::size_t contacts, bool preloaded, std::uint64_t seed) {
  RandomSource random(seed * 1000003 + contacts);
  const std::size_t pairs = (contacts + 1) / 2;
  std::vector<Contact> result;
  switch (layout) {
    case Layout::kRound:
      result = on_boundary(random, contacts, preloaded, unit_directions());
      break;
    case Layout::kArc:
      result = on_boundary(random, contacts, preloaded, arc_normals());
      break;
    case Layout::kEdges:
      result = on_edges(random, contacts, preloaded);
      break;
    case Layout::kGrid:
      result = on_grid_points(random, contacts, preloaded);
      break;
    case Layout::kJaws:
      result = on_jaws(random, pairs, preloaded);
      break;
    case Layout::kDisc:
      result = on_disc(random, pairs, preloaded);
      break;
    case Layout::kVaried:
      result = on_varied_boundary(random, contacts, preloaded);
      break;
  }
  return Grasp(std::move(result), std::string(name_of(layout)) + " " +
                                      std::to_string(contacts) +
                                      (preloaded ? " preloaded " : " ") + std::to_string(seed));
}

}  // namespace stickslip::bench
