// SPDX-License-Identifier: GPL-3.0-or-later
// Every arrangement of a few planes with normals in {-1, 0, 1}^3, against the oracle.
#include <gtest/gtest.h>

#include <functional>

#include "families.hpp"
#include "rounds.hpp"

namespace stickslip {
namespace {

/// All 26 nonzero normals, or the 13 lines: those whose first nonzero entry is positive.
std::vector<Vector3> unit_grid_normals(bool one_per_line) {
  std::vector<Vector3> normals;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const int leading = x != 0 ? x : y != 0 ? y : z;
        if (leading == 0 || (one_per_line && leading < 0)) continue;
        normals.push_back({x, y, z});
      }
    }
  }
  return normals;
}

/// Visits every multiset of `size` of the normals, the number of which it gives.
std::size_t for_each_multiset(const std::vector<Vector3>& normals, std::size_t size,
                              const std::function<void(const std::vector<Vector3>&)>& visit) {
  std::size_t visited = 0;
  std::vector<Vector3> chosen;
  const std::function<void(std::size_t)> extend = [&](std::size_t first) {
    if (chosen.size() == size) {
      ++visited;
      visit(chosen);
      return;
    }
    for (std::size_t i = first; i < normals.size(); ++i) {
      chosen.push_back(normals[i]);
      extend(i);
      chosen.pop_back();
    }
  };
  extend(0);
  return visited;
}

TEST(SmallWorlds, EveryMultisetOfUpToFiveLines) {
  const std::vector<Vector3> lines = unit_grid_normals(true);
  ASSERT_EQ(lines.size(), 13u);
  const std::size_t most = test::kSanitized ? 4 : 5;
  std::size_t total = 0;
  for (std::size_t size = 0; size <= most; ++size) {
    total += for_each_multiset(lines, size, test::expect_equals_oracle);
  }
  EXPECT_EQ(total, 1u + 13u + 91u + 455u + 1820u + (most == 5 ? 6188u : 0));
}

TEST(SmallWorlds, EveryMultisetOfUpToThreeOrientedPlanes) {
  const std::vector<Vector3> normals = unit_grid_normals(false);
  ASSERT_EQ(normals.size(), 26u);
  std::size_t total = 0;
  for (std::size_t size = 0; size <= 3; ++size) {
    total += for_each_multiset(normals, size, test::expect_equals_oracle);
  }
  EXPECT_EQ(total, 1u + 26u + 351u + 3276u);
}

TEST(SmallWorlds, AllLinesTogether) {
  test::expect_equals_oracle(unit_grid_normals(true));
  test::expect_equals_oracle(unit_grid_normals(false));
}

}  // namespace
}  // namespace stickslip
