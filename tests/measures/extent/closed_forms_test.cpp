// SPDX-License-Identifier: GPL-3.0-or-later
// What a pinch holds, in closed form: two pads press on the body from the left and the right,
// in the plane or in space, and friction alone carries a load across.
#include <gtest/gtest.h>

#include "stickslip/measures/map.hpp"
#include "stickslip/measures/preload.hpp"
#include "stickslip/measures/quality.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {
namespace closed_forms_test {

constexpr NormalLaw kLaw = NormalLaw::kUnilateral;
const Rational kFriction(1, 2);

/// Pads at a distance of `arm` with this friction.
GraspBox pinch(const Rational& arm, const Rational& preload, const RationalRow& wrench) {
  GraspBox box;
  for (const int side : {-1, 1}) {
    UncertainContact& c = box.contacts.emplace_back();
    c.position = {point_interval(side * arm), point_interval(0)};
    c.normal = {-side, 0};
    if (wrench.size() == 6) {
      c.position.push_back(point_interval(0));
      c.normal.emplace_back(0);
    }
    c.friction = point_interval(kFriction);
    c.preload = point_interval(preload);
  }
  for (const Rational& w : wrench) box.wrench.push_back(point_interval(w));
  return box;
}

// The pads press with P1 + P2 in all, however the body moves between them, and each carries
// half of the load: the least sum is the load over the friction, for the heavier of two loads.
TEST(LeastPreload, OfAPinchIsTheLoadOverItsFriction) {
  for (const Rational& unit : {Rational(1), Rational(1, 100)}) {
    const Rational least = 3 * unit / kFriction;
    const LeastPreload found = find_least_preload(
        {pinch(unit, 0, {0, -3 * unit, 0}), pinch(unit, 0, {0, 2 * unit, 0})}, kLaw);
    ASSERT_TRUE(found.preloads);
    const Rational sum = (*found.preloads)[0] + (*found.preloads)[1];
    EXPECT_GE(sum, least);
    EXPECT_LE(found.bound, least);
    EXPECT_GE(found.bound * Rational(21, 20), sum * Rational(99, 100));
    EXPECT_EQ(found.held.size(), 2U);
  }
}

// A load towards a pad needs no preload.
TEST(LeastPreload, OfAPushIsNothing) {
  const LeastPreload found = find_least_preload({pinch(1, 0, {1, 0, 0})}, kLaw);
  ASSERT_TRUE(found.preloads);
  EXPECT_EQ((*found.preloads)[0] + (*found.preloads)[1], 0);
  EXPECT_EQ(found.bound, 0);
}

// Friction carries |f_y| + |torque| of at most mu (P1 + P2 - |f_x|) with arms of 1: a ball of
// mu (P1 + P2) / sqrt(2 + mu^2), which is a third of P1 + P2 as mu is 1/2. The unit of length
// does not matter if torques are divided by it.
TEST(Quality, OfAPinchIsAThirdOfItsPreloads) {
  for (const Rational& arm : {Rational(1), Rational(5)}) {
    LoadBall shape;
    shape.length = arm;
    const Quality quality = find_quality(pinch(arm, 3, {0, 0, 0}), kLaw, shape);
    EXPECT_EQ(quality.stable, true);
    EXPECT_LE(quality.proved, 2);
    ASSERT_TRUE(quality.refuted);
    EXPECT_GE(*quality.refuted, 2);
    EXPECT_LE(*quality.refuted - quality.proved, Rational(1, 20));
  }
}

// A budget of 6 is best spent on both pads alike.
TEST(BallPreload, OfAPinchIsSharedAlike) {
  PreloadOptions options;
  options.most_boxes = 40;
  LoadBall shape;
  const BallPreload found = find_ball_preload(pinch(1, 0, {0, 0, 0}), kLaw, shape, 6, options);
  EXPECT_LE(found.preloads[0] + found.preloads[1], 6);
  EXPECT_LE(found.quality.proved, 2);
  EXPECT_GE(found.quality.proved, Rational(9, 5));
  if (found.bound) {
    EXPECT_GE(*found.bound, 2);
  }
}

// The load l is held iff l <= mu f (P1 + P2), for friction times f: cells tell it at all of
// their corners, and tile the map.
TEST(Map, CellsOfAPinchLieOnOneSideOfItsLine) {
  const GraspBox grasp = pinch(1, 1, {0, -1, 0});
  const MapAxis x = parse_axis(grasp, "friction=0:2", "--x");
  const MapAxis y = parse_axis(grasp, "load=0:2", "--y");
  EXPECT_EQ(x.kind, AxisKind::kFriction);
  EXPECT_EQ(y.kind, AxisKind::kLoad);
  MapOptions options;
  options.depth = 3;
  Rational area = 0;
  int cells = 0;
  double done = 0;
  map_verdicts(
      grasp, kLaw, x, y, options,
      [&](const MapCell& cell) {
        ++cells;
        area += (cell.x.high - cell.x.low) * (cell.y.high - cell.y.low);
        const std::optional<bool> stable = is_stable(cell.decision.verdict);
        if (stable == true) {
          EXPECT_LE(cell.y.high, cell.x.low);
        }
        if (stable == false) {
          EXPECT_GT(cell.y.low, cell.x.high);
        }
        // Only on the line there is no one verdict.
        if (!stable) {
          EXPECT_TRUE(cell.y.low <= cell.x.high && cell.y.high >= cell.x.low);
        }
      },
      [&](double part) {
        EXPECT_GE(part, done);
        done = part;
      });
  EXPECT_EQ(area, 4);
  EXPECT_EQ(done, 1);
  EXPECT_GE(cells, 15);
}

// A body that its weight presses 1 deep into the ground is not held by less motion, with
// whatever friction: corners of cells are asked about with the bound, and one cell says it.
TEST(Map, PointsKnowTheBoundOfMotions) {
  GraspBox grasp;
  UncertainContact& ground = grasp.contacts.emplace_back();
  ground.position = {point_interval(0), point_interval(0)};
  ground.normal = {0, 1};
  ground.friction = point_interval(1);
  grasp.wrench = {point_interval(Rational(1, 2)), point_interval(-1), {}};
  grasp.max_motion.assign(3, Rational(1, 2));
  const MapAxis x = parse_axis(grasp, "friction=0:1", "--x");
  const MapAxis y = parse_axis(grasp, "stiffness=1/2:1", "--y");
  MapOptions options;
  options.depth = 2;
  int cells = 0;
  map_verdicts(grasp, kLaw, x, y, options,
               [&](const MapCell& cell) {
                 ++cells;
                 EXPECT_EQ(is_stable(cell.decision.verdict), false);
               },
               {});
  EXPECT_EQ(cells, 1);
}

// In space pads carry l (0, 3, 4), of length 5 l, up to mu (P1 + P2): l is at most 3/5.
TEST(SpatialMargin, OfAPinchEndsWhereItsFrictionEnds) {
  Question question;
  question.grasp = pinch(1, 3, RationalRow(6));
  question.direction = RationalRow{0, 3, 4, 0, 0, 0};
  const SpatialMargin margin = find_spatial_margin(question);
  const Rational end(3, 5);
  const std::vector<MarginInterval> resisted = margin.resisted();
  const std::vector<MarginInterval> refuted = margin.refuted();
  ASSERT_EQ(resisted.size(), 1U);
  ASSERT_EQ(refuted.size(), 1U);
  EXPECT_EQ(resisted.front().low, 0);
  EXPECT_FALSE(refuted.front().high);
  ASSERT_TRUE(resisted.front().high);
  EXPECT_LE(*resisted.front().high, end);
  EXPECT_GE(refuted.front().low, end);
  EXPECT_LE(refuted.front().low - *resisted.front().high, end * Rational(3, 1000));
}

}  // namespace closed_forms_test
}  // namespace stickslip
