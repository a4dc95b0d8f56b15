// SPDX-License-Identifier: GPL-3.0-or-later
// Proposals over cones: forces and motions that were planted are found, to many digits and deep
// in their cones.
#include "stickslip/lp/cone_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace stickslip {
namespace {

using Cone = std::vector<double>;

double depth(const Cone& z) {
  double tail = 0;
  for (std::size_t k = 1; k < z.size(); ++k) tail = std::hypot(tail, z[k]);
  return z[0] - tail;
}

/// Returns a row of numbers between -1 and 1.
std::vector<double> numbers(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> draw(-1, 1);
  std::vector<double> result(count);
  for (double& x : result) x = draw(random);
  return result;
}

DoubleColumn column_of(const std::vector<double>& row) {
  DoubleColumn column;
  for (std::size_t j = 0; j < row.size(); ++j) column.emplace_back(j, row[j]);
  return column;
}

double dot(const DoubleColumn& column, const std::vector<double>& x) {
  double sum = 0;
  for (const auto& [row, entry] : column) sum += entry * x[row];
  return sum;
}

TEST(ConeProgram, FindsForcesThatWerePlanted) {
  std::mt19937 random(1);
  for (const bool is_long : {false, true}) {
    for (int round = 0; round < 60; ++round) {
      const std::size_t rows = 3 + static_cast<std::size_t>(round) % 10;
      ConePair pair{std::vector<double>(rows), {}};
      for (std::size_t i = 0; i < rows; ++i) {
        const std::size_t size = 1 + i % 4;
        Cone z = numbers(random, size);
        z[0] = 3;  // deep
        auto& cone = pair.cones.emplace_back();
        for (std::size_t k = 0; k < size; ++k) {
          cone.push_back(column_of(numbers(random, rows)));
          for (const auto& [row, entry] : cone.back()) pair.load[row] -= z[k] * entry;
        }
      }
      const ConeSearch search(pair, is_long);
      const ConeProposal& found = search.proposal();
      ASSERT_TRUE(found.rests) << round;
      std::vector<double> sum = pair.load;
      double largest = 0;
      for (std::size_t i = 0; i < pair.cones.size(); ++i) {
        EXPECT_GT(depth(found.forces[i]), 0) << round;
        largest = std::max(largest, found.forces[i][0]);
        for (std::size_t k = 0; k < pair.cones[i].size(); ++k) {
          for (const auto& [row, entry] : pair.cones[i][k])
            sum[row] += found.forces[i][k] * entry;
        }
      }
      for (const double entry : sum) EXPECT_LT(std::fabs(entry), 1e-7 * largest) << round;
      // Changes take away what is off.
      const auto changes = search.changes(sum);
      for (std::size_t i = 0; i < pair.cones.size(); ++i) {
        for (std::size_t k = 0; k < pair.cones[i].size(); ++k) {
          for (const auto& [row, entry] : pair.cones[i][k]) sum[row] += changes[i][k] * entry;
        }
      }
      for (const double entry : sum) EXPECT_LT(std::fabs(entry), 1e-10 * largest) << round;
      EXPECT_LT(found.steps, 40);
    }
  }
}

TEST(ConeProgram, FindsAMotionThatWasPlanted) {
  std::mt19937 random(2);
  for (int round = 0; round < 60; ++round) {
    const std::size_t rows = 3 + static_cast<std::size_t>(round) % 10;
    const std::vector<double> x = numbers(random, rows);
    ConePair pair{x, {}};  // the load does work along x
    while (pair.cones.size() < 2 * rows) {
      const std::size_t size = 1 + pair.cones.size() % 4;
      std::vector<DoubleColumn> cone;
      Cone seen;
      for (std::size_t k = 0; k < size; ++k) {
        cone.push_back(column_of(numbers(random, rows)));
        seen.push_back(dot(cone.back(), x));
      }
      if (depth(seen) > 0.05) pair.cones.push_back(std::move(cone));
    }
    const ConeSearch search(pair);
    const ConeProposal& found = search.proposal();
    ASSERT_FALSE(found.rests) << round;
    EXPECT_GT(dot(column_of(pair.load), found.motion), 0) << round;
    for (const auto& cone : pair.cones) {
      Cone seen;
      for (const DoubleColumn& column : cone) seen.push_back(dot(column, found.motion));
      EXPECT_GT(depth(seen), 0) << round;
    }
    EXPECT_LT(found.steps, 40);
  }
}

}  // namespace
}  // namespace stickslip
