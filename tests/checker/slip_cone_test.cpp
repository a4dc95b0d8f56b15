// SPDX-License-Identifier: MIT
// The cone C_i of FORMAT.md §7 against pairs of its generators, on all small sets of a grid.
#include "slip_cone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace stickslip_check {
namespace {

Form cross(const Form& a, const Form& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_zero(const Form& s) {
  return sign_of_dot(s, s) == 0;
}

/// Two generators are enough.
bool spanned(const Form& s, const std::vector<Form>& generators) {
  const auto by_one = [&](const Form& g) {
    return is_zero(cross(g, s)) && sign_of_dot(g, s) > 0;
  };
  if (is_zero(s) || std::any_of(generators.begin(), generators.end(), by_one)) return true;
  for (const Form& a : generators) {
    for (const Form& b : generators) {
      const Form c = cross(a, b);
      // s = (s x b).c / c.c a + (a x s).c / c.c b
      if (!is_zero(c) && sign_of_dot(cross(s, b), c) >= 0 && sign_of_dot(cross(a, s), c) >= 0) {
        return true;
      }
    }
  }
  return false;
}

/// The plane's own grid of nine.
std::vector<Form> grid_across(const Form& normal) {
  std::vector<Form> basis;
  for (const Form& e : {Form{1, 0, 0}, Form{0, 1, 0}, Form{0, 0, 1}}) {
    if (!is_zero(cross(normal, e))) basis.push_back(cross(normal, e));
  }
  std::vector<Form> grid;
  for (const int i : {-1, 0, 1}) {
    for (const int j : {-1, 0, 1}) {
      Form s(3);
      for (std::size_t k = 0; k < 3; ++k) s[k] = i * basis[0][k] + j * basis[1][k];
      grid.push_back(std::move(s));
    }
  }
  return grid;
}

TEST(SlipCone, OfAllSmallSets) {
  for (const Form& normal : {Form{0, 0, 1}, Form{1, 2, -2}, Form{0, -3, 0}}) {
    const std::vector<Form> grid = grid_across(normal);
    const Vector n(normal.begin(), normal.end());
    for (unsigned chosen = 0; chosen < 1U << grid.size(); ++chosen) {
      SlipCone cone(n);
      std::vector<Form> generators;
      for (std::size_t k = 0; k < grid.size(); ++k) {
        // In another order for each set.
        const std::size_t at = (k * 4 + chosen) % grid.size();
        if ((chosen >> at & 1U) == 0) continue;
        generators.push_back(grid[at]);
        cone.add(grid[at]);
      }
      for (const Form& s : grid) EXPECT_EQ(cone.contains(s), spanned(s, generators)) << chosen;
      for (const Form& side : cone.sides()) {
        EXPECT_TRUE(std::count(generators.begin(), generators.end(), side) > 0);
        // Nothing of the cone is at one of the two hands of a side.
        bool turned[2]{false, false};
        for (const Form& g : generators) {
          const Form c = cross(side, g);
          const int hand = sign_of_dot(c, normal);
          if (hand != 0) turned[hand > 0 ? 1 : 0] = true;
        }
        EXPECT_FALSE(turned[0] && turned[1]) << chosen;
      }
      const bool whole = cone.sides().empty() &&
                         !is_zero(std::accumulate(generators.begin(), generators.end(), Form(3),
                                                  [](Form sum, const Form& g) {
                                                    for (std::size_t k = 0; k < 3; ++k)
                                                      sum[k] += abs(g[k]);
                                                    return sum;
                                                  }));
      EXPECT_EQ(whole, std::all_of(grid.begin(), grid.end(),
                                   [&](const Form& s) { return spanned(s, generators); }))
          << chosen;
    }
  }
}

}  // namespace
}  // namespace stickslip_check
