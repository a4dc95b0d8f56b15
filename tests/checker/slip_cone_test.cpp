// SPDX-License-Identifier: MIT
// The cone C_i of FORMAT.md §7, and M(c), on small sets of a grid: against all sets of
// three of its generators, in the numbers of the document, of which none is left out.
#include "slip_cone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>

#include "support.hpp"

namespace stickslip_check {
namespace {

/// A slip as the document has it, and its product.
struct World {
  Vector normal;
  Rational gamma;  ///< without it, slips have three numbers

  Rational product(const Vector& s, const Vector& t) const {
    Rational sum;
    for (std::size_t j = 0; j < s.size(); ++j)
      sum += (j < 3 ? Rational(1) : gamma) * s[j] * t[j];
    return sum;
  }

  Form shortened(const Vector& s) const {
    Form result;
    const std::size_t left_out = SlipProduct(normal, gamma).left_out;
    for (std::size_t j = 0; j < s.size(); ++j) {
      if (j != left_out) result.push_back(s[j].get_num());
    }
    return result;
  }

  /// -1, 0 and 1 times two vectors across n; and, with gamma, of each with -1, 0 and 1.
  std::vector<Vector> grid() const {
    std::vector<Vector> basis;
    for (const Vector& e : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
      const Vector across = cross(normal, e);
      if (dot(across, across) != 0) basis.push_back(across);
    }
    std::vector<Vector> result;
    for (const int turn : {-1, 0, 1}) {
      if (gamma == 0 && turn != 0) continue;
      for (const int i : {-1, 0, 1}) {
        for (const int j : {-1, 0, 1}) {
          Vector s;
          for (std::size_t k = 0; k < 3; ++k) s.emplace_back(i * basis[0][k] + j * basis[1][k]);
          if (gamma != 0) s.emplace_back(turn);
          result.push_back(std::move(s));
        }
      }
    }
    return result;
  }
};

/// The determinant of three vectors, of which the first `size` numbers count.
Rational determinant(const std::array<Vector, 3>& m, std::size_t size) {
  if (size == 1) return m[0][0];
  if (size == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return dot(m[0], cross(m[1], m[2]));
}

/// The square of the nearest point to q on the span of these slips; nothing unless it is a sum
/// of multiples >= 0, and they are linearly independent.
std::optional<Rational> projected(const World& world, const Vector& q,
                                  const std::vector<Vector>& slips) {
  std::array<Vector, 3> products{Vector(3), Vector(3), Vector(3)};
  Vector heights(3);
  for (std::size_t a = 0; a < slips.size(); ++a) {
    heights[a] = world.product(q, slips[a]);
    for (std::size_t b = 0; b < slips.size(); ++b) {
      products[a][b] = world.product(slips[a], slips[b]);
    }
  }
  const Rational all = determinant(products, slips.size());
  if (all == 0) return std::nullopt;
  Rational square;
  for (std::size_t a = 0; a < slips.size(); ++a) {
    std::array<Vector, 3> with = products;  // which is symmetric
    with[a] = heights;
    const Rational multiple = determinant(with, slips.size()) / all;
    if (multiple < 0) return std::nullopt;
    square += multiple * heights[a];
  }
  return square;
}

/// How many slips the nearest point takes: 0 to 3.
struct Naive {
  Rational square = 0;  ///< of the nearest point
  std::size_t slips = 0;
};

Naive nearest(const World& world, const Vector& q, const std::vector<Vector>& slips) {
  Naive best;
  const auto consider = [&](const std::vector<Vector>& some) {
    const auto square = projected(world, q, some);
    if (square && *square > best.square) best = {*square, some.size()};
  };
  for (std::size_t a = 0; a < slips.size(); ++a) {
    consider({slips[a]});
    for (std::size_t b = 0; b < a; ++b) {
      consider({slips[a], slips[b]});
      // Of a plane no three are independent.
      for (std::size_t c = 0; world.gamma != 0 && c < b; ++c) {
        consider({slips[a], slips[b], slips[c]});
      }
    }
  }
  return best;
}

/// M(c), squared and with its sign.
Rational most_along(const World& world, const Vector& t, const std::vector<Vector>& slips,
                    std::array<int, 4>& seen) {
  Vector q;
  for (const Rational& c : t) q.emplace_back(-c);
  const Naive best = nearest(world, q, slips);
  ++seen[best.slips];
  if (best.square > 0) return best.square;
  std::optional<Rational> most;
  for (const Vector& s : slips) {
    const Rational size = world.product(s, s);
    if (size == 0) continue;
    const Rational along = world.product(q, s);
    const Rational signed_square = along * abs(along) / size;
    if (!most || signed_square > *most) most = signed_square;
  }
  return *most;
}

/// Of a cone of these slips: which of the grid it contains, and M(c) of all of the grid.
void compare(const World& world, const std::vector<Vector>& slips,
             const std::vector<Vector>& grid, std::array<int, 4>& seen) {
  const SlipProduct product(world.normal, world.gamma);
  SlipCone cone(product);
  bool moves = false;
  for (const Vector& s : slips) {
    cone.add(world.shortened(s));
    moves = moves || dot(s, s) != 0;
  }
  for (const Vector& s : grid) {
    const Form shortened = world.shortened(s);
    EXPECT_EQ(product.square(shortened), world.product(s, s));
    const bool inside = nearest(world, s, slips).square == world.product(s, s);
    EXPECT_EQ(cone.contains(shortened), inside) << show(s);
    if (moves) {
      EXPECT_EQ(cone.most_along(shortened), most_along(world, s, slips, seen)) << show(s);
    }
  }
}

TEST(SlipCone, OfAllSmallSetsAcrossNormals) {
  std::array<int, 4> seen{};
  for (const Vector& normal : {Vector{0, 0, 1}, Vector{1, 2, -2}, Vector{0, -3, 0}}) {
    const World world{normal, 0};
    const std::vector<Vector> grid = world.grid();
    for (unsigned chosen = 0; chosen < 1U << grid.size(); ++chosen) {
      std::vector<Vector> slips;
      for (std::size_t k = 0; k < grid.size(); ++k) {
        // In another order for each set.
        const std::size_t at = (k * 4 + chosen) % grid.size();
        if ((chosen >> at & 1U) != 0) slips.push_back(grid[at]);
      }
      compare(world, slips, grid, seen);
    }
  }
  EXPECT_GT(seen[0], 100);
  EXPECT_GT(seen[1], 100);
  EXPECT_GT(seen[2], 100);
}

TEST(SlipCone, OfSetsWithTorsion) {
  std::array<int, 4> seen{};
  std::mt19937 random(15);
  const auto below = [&](std::size_t n) { return random() % n; };
  for (const World& world : {World{{0, 0, 1}, 1}, World{{1, 2, -2}, Rational(1, 36)},
                             World{{0, -3, 0}, Rational(7, 2)}}) {
    const std::vector<Vector> grid = world.grid();
    for (int round = 0; round < rounds(40); ++round) {
      std::vector<Vector> slips;
      for (std::size_t count = below(8); slips.size() < count;) {
        Vector s = grid[below(grid.size())];
        // Off the grid, or opposite to one before, in turn.
        if (below(3) == 0) {
          const Vector& other = grid[below(grid.size())];
          for (std::size_t j = 0; j < s.size(); ++j) s[j] += 2 * other[j];
        } else if (below(3) == 0 && !slips.empty()) {
          for (std::size_t j = 0; j < s.size(); ++j) s[j] = -slips.front()[j];
        }
        slips.push_back(std::move(s));
      }
      compare(world, slips, grid, seen);
    }
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

/// A point, a ray, a line, a wedge, a half plane, a plane, a wedge of space and with an edge
/// that is a line, half of space and all of it.
TEST(SlipCone, OfEveryShape) {
  std::array<int, 4> seen{};
  const World world{{0, 0, 1}, Rational(1, 4)};
  const std::vector<Vector> grid = world.grid();
  const Vector x{1, 0, 0, 0};
  const Vector y{0, 1, 0, 0};
  const Vector turn{0, 0, 0, 1};
  const auto minus = [](Vector s) {
    for (Rational& c : s) c = -c;
    return s;
  };
  for (const std::vector<Vector>& slips :
       {std::vector<Vector>{},
        {Vector(4)},
        {x},
        {x, minus(x)},
        {x, turn},
        {x, minus(x), turn},
        {x, minus(x), turn, minus(turn)},
        {x, y, turn},
        {x, minus(x), y, turn},
        {x, minus(x), y, minus(y), turn},
        {{1, 1, 0, 1}, {-1, 0, 0, 1}, {0, -1, 0, 1}, turn},
        {x, minus(x), y, minus(y), turn, minus(turn)},
        {{1, 1, 0, 1}, {-1, 0, 0, 1}, {0, -1, 0, 1}, minus(turn)}}) {
    compare(world, slips, grid, seen);
    std::vector<Vector> twice = slips;
    twice.insert(twice.end(), slips.rbegin(), slips.rend());
    compare(world, twice, grid, seen);
  }
}

}  // namespace
}  // namespace stickslip_check
