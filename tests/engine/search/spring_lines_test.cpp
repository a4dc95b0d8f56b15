// SPDX-License-Identifier: GPL-3.0-or-later
// What springs do along the lines of a region, and the twists that do not see it.
#include "engine/search/spring_lines.hpp"

#include <gtest/gtest.h>

#include <array>

#include "law_cases.hpp"

namespace stickslip {
namespace spring_lines_test {

using search_detail::SpringLines;
using test::RandomSource;

/// A law of springs alone, in four coordinates, one of which is a rotation.
Law springs(RandomSource& random, int count) {
  Law law;
  law.motions = 4;
  law.rotates = {0, 0, 1, 0};
  law.wrench.assign(4, {});
  for (int k = 0; k < count; ++k) {
    LawContact& c = law.contacts.emplace_back();
    c.is_spring = true;
    const Rational stiffness(random.between(1, 4), 2);
    c.stiffness = {stiffness, random.one_in(3) ? Rational(stiffness + 1) : stiffness};
    CornerRow& row = c.corners.emplace_back();
    while (row.normal.size() < 4) row.normal.emplace_back(random.between(-2, 2));
    row.set_slip({RationalRow(4)}, 1);
  }
  law.complete(random.between(1, 3));
  return law;
}

/// The wrenches of springs that a twist must not see: by the definition in the header.
std::vector<RationalRow> wrenches_along(const Law& law, const Row& line) {
  std::vector<RationalRow> result{RationalRow(4)};
  for (const LawContact& c : law.contacts) {
    const RationalRow& n = c.corners.front().normal;
    const Rational along = dot(n, RationalRow(line.begin(), line.end()));
    if (along.is_zero()) continue;
    if (c.stiffness.is_point()) {
      for (std::size_t j = 0; j < 4; ++j) result[0][j] += c.stiffness.low * along * n[j];
    } else {
      result.push_back(n);
    }
  }
  return result;
}

TEST(SpringLines, TwistsDoNotSeeWhatSpringsDoAlongLines) {
  RandomSource random(261);
  std::array<int, 2> seen{};
  for (int round = 0; round < 200; ++round) {
    const Law law = springs(random, random.between(0, 3));
    MotionRegion region = MotionRegion::root(law);
    for (int cuts = random.between(0, 3); cuts > 0; --cuts) {
      Row plane(6);
      for (std::size_t j = 0; j < 4; ++j) plane[j] = random.between(-1, 1);
      if (!is_zero(plane)) region = std::move(region.halves(plane).front());
    }
    const std::size_t lines = region.cone().lines().size();
    SpringLines found(law, region);
    std::vector<RationalRow> hidden;
    for (std::size_t k = 0; k < lines; ++k) {
      for (RationalRow& wrench : wrenches_along(law, region.points()[2 * k])) {
        hidden.push_back(std::move(wrench));
      }
    }
    // Rays may be taken, too, but once.
    if (random.one_in(2) && 2 * lines < region.points().size()) {
      const std::size_t ray = 2 * lines;
      EXPECT_EQ(found.add({ray}), !law.contacts.empty());
      EXPECT_FALSE(found.add({ray}));
      for (RationalRow& wrench : wrenches_along(law, region.points()[ray])) {
        hidden.push_back(std::move(wrench));
      }
    }
    const ForceSpan span(4, hidden);
    EXPECT_EQ(found.empty(), span.rank() == 0);
    ++seen[found.empty() ? 1 : 0];
    for (std::size_t g = 0; g < 2 * lines; ++g) EXPECT_EQ(found.has(g), !found.empty());
    Row y(4);
    for (Integer& entry : y) entry = random.between(-9, 9);
    const Row near = found.twist_near(y);
    const RationalRow twist(near.begin(), near.end());
    for (const RationalRow& wrench : hidden) EXPECT_TRUE(dot(twist, wrench).is_zero());
    // A twist of the subspace stays as it is, and a wrench keeps the work that it does on it.
    EXPECT_EQ(found.twist_near(near), near);
    Reals wrench(4);
    for (Eigen::Index j = 0; j < 4; ++j) wrench[j] = random.between(-9, 9);
    Reals rounded = in_doubles(near);
    law.scale(rounded);
    const double work = wrench.dot(rounded);
    found.project(wrench);
    EXPECT_NEAR(wrench.dot(rounded), work, 1e-9);
    // Nothing is left of a wrench of springs.
    for (const RationalRow& spring : hidden) {
      Reals left(4);
      for (std::size_t j = 0; j < 4; ++j) {
        left[static_cast<Eigen::Index>(j)] = to_double(spring[j]);
      }
      law.scale_function(left);
      found.project(left);
      EXPECT_NEAR(left.norm(), 0, 1e-9);
    }
  }
  EXPECT_GE(seen[0], 50);
  EXPECT_GE(seen[1], 10);
}

}  // namespace spring_lines_test
}  // namespace stickslip
