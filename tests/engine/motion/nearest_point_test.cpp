// SPDX-License-Identifier: GPL-3.0-or-later
// Points of least norm in hulls, by the condition that no other point satisfies.
#include "engine/motion/nearest_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/motion/nearest_wrench.hpp"
#include "random_grasps.hpp"

namespace stickslip {
namespace nearest_point_test {

using test::RandomSource;

template <class Point>
Point zero(std::size_t n);
template <>
Double3 zero<Double3>(std::size_t) {
  return {};
}
template <>
std::array<double, 6> zero<std::array<double, 6>>(std::size_t) {
  return {};
}
template <>
Reals zero<Reals>(std::size_t n) {
  return Reals::Zero(static_cast<Eigen::Index>(n));
}

/// Points at random, around one that is 0 or not.
template <class Point>
std::vector<Point> random_points(RandomSource& random, std::size_t n) {
  const Point none = zero<Point>(n);
  std::vector<int> centre;
  for (std::size_t j = 0; j < n; ++j) centre.push_back(random.between(-4, 4));
  const bool is_around = random.one_in(2);
  std::vector<Point> points;
  for (int k = random.between(1, 12); k > 0; --k) {
    Point& point = points.emplace_back(none);
    std::size_t j = 0;
    for (double& entry : point) entry = random.between(-5, 5) + (is_around ? centre[j++] : 0);
  }
  return points;
}

/// Wolfe's way: adds the point that is farthest against the nearest one until there is none.
template <class Point>
void expect_nearest(RandomSource& random, std::size_t n, std::array<int, 2>& seen) {
  const std::vector<Point> points = random_points<Point>(random, n);
  NearestPointOf<Point> hull;
  std::vector<std::size_t> added;
  for (int step = 0; step < 200; ++step) {
    const bool first = hull.size() == 0;
    std::size_t least = 0;
    double before = 0;
    if (!first) {
      for (std::size_t k = 1; k < points.size(); ++k) {
        if (dot(points[k], hull.nearest()) < dot(points[least], hull.nearest())) least = k;
      }
      before = dot(hull.nearest(), hull.nearest());
      if (dot(points[least], hull.nearest()) > before - 1e-9) break;
    }
    added.push_back(least);
    if (!hull.add(points[least])) break;
    EXPECT_TRUE(first || dot(hull.nearest(), hull.nearest()) < before);
  }
  // The point is a combination of points that were added.
  ASSERT_LE(hull.size(), n + 1);
  Point sum = zero<Point>(n);
  double weights = 0;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    EXPECT_GE(hull.weight(k), -1e-12);
    weights += hull.weight(k);
    std::size_t j = 0;
    for (double& entry : sum) {
      entry +=
          hull.weight(k) * *(points[added[hull.order(k)]].begin() + static_cast<long>(j++));
    }
  }
  EXPECT_NEAR(weights, 1, 1e-9);
  const Point& nearest = hull.nearest();
  const double square = dot(nearest, nearest);
  for (std::size_t j = 0; j < n; ++j) {
    EXPECT_NEAR(*(sum.begin() + static_cast<long>(j)),
                *(nearest.begin() + static_cast<long>(j)), 1e-9);
  }
  for (const Point& point : points) EXPECT_GE(dot(point, nearest), square - 1e-7);
  ++seen[square > 1e-9 ? 1 : 0];
}

TEST(NearestPoint, NoPointOfTheHullIsNearer) {
  RandomSource random(281);
  std::array<int, 2> seen{};
  for (int round = 0; round < 300; ++round) {
    expect_nearest<Double3>(random, 3, seen);
    expect_nearest<std::array<double, 6>>(random, 6, seen);
    expect_nearest<Reals>(random, 4, seen);
  }
  for (const int count : seen) EXPECT_GE(count, 100);
}

/// A wrench that does so much work on a twist.
struct Support {
  double work;
  Double3 wrench;
};

// The search finds a twist that all wrenches are against, or wrenches that add up to 0.
TEST(NearestWrench, SeparatesOrBalances) {
  RandomSource random(282);
  std::array<int, 2> seen{};
  for (int round = 0; round < 400; ++round) {
    const std::vector<Double3> points = random_points<Double3>(random, 3);
    const auto worst = [&](const Double3& y) {
      Support best{-HUGE_VAL, {}};
      for (const Double3& point : points) {
        if (dot(point, y) > best.work) best = {dot(point, y), point};
      }
      return std::optional(best);
    };
    const bool deep = random.one_in(2);
    const auto found = nearest_wrench(Double3{1, 0, 0}, worst, deep);
    ++seen[found.separated ? 1 : 0];
    if (found.separated) {
      for (const Double3& point : points) EXPECT_LT(dot(point, found.twist), 0);
      continue;
    }
    Double3 sum{};
    double weights = 0;
    for (const auto& [weight, support] : found.parts) {
      weights += weight;
      for (std::size_t j = 0; j < 3; ++j) sum[j] += weight * support.wrench[j];
    }
    EXPECT_NEAR(weights, 1, 1e-9);
    for (const double entry : sum) EXPECT_NEAR(entry, 0, 1e-6);
  }
  for (const int count : seen) EXPECT_GE(count, 60);
}

}  // namespace nearest_point_test
}  // namespace stickslip
