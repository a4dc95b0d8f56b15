// SPDX-License-Identifier: GPL-3.0-or-later
// Walls around the equilibrium of a pinch: what they enclose, and how they move.
#include "engine/degree/walls.hpp"

#include <gtest/gtest.h>

#include <array>

#include "engine/degree/wall_refuter.hpp"
#include "random_grasps.hpp"
#include "stickslip/engine/near_forces.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {
namespace walls_test {

using degree_detail::Walls;
using test::RandomSource;

/// Pads at random press with 2 from the left and the right, under a load that they hold.
GraspBox pinch(RandomSource& random) {
  GraspBox box;
  for (const int side : {-1, 1}) {
    UncertainContact& c = box.contacts.emplace_back();
    c.position = {point_interval(side), point_interval(Rational(random.between(-1, 1), 8))};
    c.normal = {-side, 0};
    c.friction = {Rational(1, 2), Rational(3, 4)};
    c.stiffness = point_interval(random.between(1, 3));
    c.preload = point_interval(2);
  }
  box.wrench = {point_interval(Rational(random.between(-2, 2), 4)),
                point_interval(Rational(random.between(-2, 2), 4)),
                point_interval(Rational(random.between(-1, 1), 8))};
  return box;
}

Rational largest(const DegreeProof& proof, const RationalRow& motion, bool both_ways) {
  Rational most = -1000;
  for (const RationalRow& wall : proof.walls) {
    Rational at = 0;
    for (std::size_t j = 0; j < motion.size(); ++j)
      at += wall[j] * (motion[j] - proof.twist[j]);
    most = std::max<Rational>(most, both_ways ? Rational(abs(at)) : at);
  }
  return most;
}

RationalRow in_file(const RoundedGrasp& grasp, const Reals& motion) {
  RationalRow d;
  for (std::size_t j = 0; j < grasp.rotates.size(); ++j) {
    d.push_back(rational_from_double(motion[static_cast<Eigen::Index>(j)] / grasp.unit(j)));
  }
  return d;
}

TEST(Walls, EncloseTheEquilibriumAndItsMoves) {
  RandomSource random(321);
  int sound = 0;
  for (int round = 0; round < 60; ++round) {
    const GraspLaw law(pinch(random), NormalLaw::kUnilateral);
    const RoundedGrasp grasp = rounded_middle(law);
    const std::vector<NearEquilibrium> found = Newton(grasp).solve_from(1);
    if (found.empty()) continue;
    const NearEquilibrium& near = found.front();
    const ForceSpan span(law);
    Walls walls(grasp, span, near, 0.25, &law);
    if (!walls.is_sound()) continue;
    ++sound;
    EXPECT_EQ(walls.rows().rows(), 3);
    std::vector<Reals> moves;
    for (int k = random.between(0, 3); k > 0; --k) {
      Reals& move = moves.emplace_back(3);
      for (double& entry : move) entry = 0.05 * random.between(-4, 4);
    }
    if (random.one_in(2)) walls.turn_to(moves);
    ASSERT_TRUE(walls.is_sound());
    walls.enclose(moves);
    for (const bool is_simplex : {false, true}) {
      for (const auto pull :
           {Walls::Pull::kTwists, Walls::Pull::kFitted, Walls::Pull::kStiff}) {
        const DegreeProof proof = walls.proof(pull, is_simplex);
        EXPECT_EQ(proof.is_simplex, is_simplex);
        EXPECT_EQ(proof.walls.size(), is_simplex ? 4U : 3U);
        EXPECT_TRUE(has_rank(proof, 3));
        EXPECT_LT(largest(proof, in_file(grasp, near.motion), !is_simplex), 1);
        if (!is_simplex) {
          for (const Reals& move : moves) {
            EXPECT_LT(largest(proof, in_file(grasp, near.motion + move), true), 1);
          }
          continue;
        }
        // The walls of a simplex close: they add up to 0.
        for (std::size_t j = 0; j < 3; ++j) {
          Rational sum = 0;
          for (const RationalRow& wall : proof.walls) sum += wall[j];
          EXPECT_EQ(sum, 0);
        }
      }
    }
  }
  EXPECT_GE(sound, 30);
}

// A wall that grows goes outwards alone; of a simplex all do.
TEST(Walls, GrowOutwards) {
  RandomSource random(322);
  for (int round = 0; round < 20; ++round) {
    const GraspLaw law(pinch(random), NormalLaw::kUnilateral);
    const RoundedGrasp grasp = rounded_middle(law);
    const std::vector<NearEquilibrium> found = Newton(grasp).solve_from(1);
    if (found.empty()) continue;
    const ForceSpan span(law);
    Walls walls(grasp, span, found.front(), 0.25, &law);
    if (!walls.is_sound()) continue;
    const RationalRow near = in_file(grasp, found.front().motion);
    const auto distance = [&](const DegreeProof& proof, std::size_t wall) {
      // How many widths of the wall before growing, E.(d0 - near) + 1 over E, for its side.
      const std::size_t j = wall / 2;
      Rational at = 0;
      Rational size = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        at += proof.walls[j][k] * (proof.twist[k] - near[k]);
        size += abs(proof.walls[j][k]);
      }
      return Rational((1 + (wall % 2 == 0 ? at : Rational(-at))) / size);
    };
    const DegreeProof before = walls.proof(Walls::Pull::kTwists, false);
    const auto grown = static_cast<std::size_t>(random.between(0, 5));
    walls.grow(grown, false);
    const DegreeProof after = walls.proof(Walls::Pull::kTwists, false);
    for (std::size_t wall = 0; wall < 6; ++wall) {
      const double factor = to_double(distance(after, wall) / distance(before, wall));
      EXPECT_NEAR(factor, wall == grown ? 1.25 : 1, 0.02);
    }
    walls.grow(0, true);
    const DegreeProof all = walls.proof(Walls::Pull::kTwists, false);
    for (std::size_t wall = 0; wall < 6; ++wall) {
      const double factor = to_double(distance(all, wall) / distance(after, wall));
      EXPECT_NEAR(factor, 1.25, 0.03);
    }
  }
}

// Nothing is held without contacts that press.
TEST(Walls, AreUnsoundWhereNothingHolds) {
  GraspBox box;
  box.wrench.assign(3, {});
  UncertainContact& c = box.contacts.emplace_back();
  c.position = {point_interval(0), point_interval(1)};
  c.normal = {0, -1};
  c.friction = point_interval(0);
  const GraspLaw law(box, NormalLaw::kUnilateral);
  const RoundedGrasp grasp = rounded_middle(law);
  const NearEquilibrium rest{Reals::Zero(3), {0}, {{}}, {0}};
  const ForceSpan span(law);
  EXPECT_FALSE(Walls(grasp, span, rest, 0.25, &law).is_sound());
}

/// Returns whether the tree that begins at a node refutes the region by the exact rule of
/// leaves; `next` becomes the node behind it.
bool is_refuted(const Law& law, const MotionRegion& region, const Trees& trees,
                std::size_t& next, const PullRule* pull) {
  const TreeNode& node = trees.at(next++);
  std::vector<MotionRegion> children;
  if (const auto* slip = std::get_if<SlipSplit>(&node)) {
    children = region.slip_children(slip->contact.index());
  } else if (const auto* split = std::get_if<SeparationSplit>(&node)) {
    children = region.halves(law.contacts[split->contact.index()].separations.front());
  } else if (const auto* cut = std::get_if<PlaneCut>(&node)) {
    children = region.halves(cut->plane);
  } else {
    return region.is_refuted(std::get<TwistLeaf>(node).twist, pull);
  }
  bool all = true;
  for (const MotionRegion& child : children) {
    all = is_refuted(law, child, trees, next, pull) && all;
  }
  return all;
}

// Trees refute the walls of a body, contact by contact and in groups, with the pull and without
// it; both ways know whether all contacts are closed there.
TEST(WallRefuters, TreesRefuteWalls) {
  using degree_detail::CrowdRefuter;
  using degree_detail::LawRefuter;
  RandomSource random(325);
  std::array<int, 4> seen{};
  std::array<int, 2> closed{};
  for (int round = 0; round < 20; ++round) {
    const GraspBox box = pinch(random).middle();
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const Problem problem(loaded_of(box), NormalLaw::kUnilateral);
    const RoundedGrasp grasp = rounded_middle(law);
    const std::vector<NearEquilibrium> found = Newton(grasp).solve_from(1);
    if (found.empty()) continue;
    const ForceSpan span(law);
    const double size = random.one_in(2) ? 0.25 : 4;
    const Walls walls(grasp, span, found.front(), size, &law);
    if (!walls.is_sound()) continue;
    const DegreeProof body = walls.proof(Walls::Pull::kTwists, false);
    SearchWork work;
    LawRefuter by_law(law, law, work);
    CrowdWalls crowd(problem);
    CrowdRefuter by_crowd(crowd, work);
    const bool are_closed = by_law.all_are_closed(body);
    EXPECT_EQ(by_crowd.all_are_closed(body), are_closed);
    ++closed[are_closed ? 1 : 0];
    const PullRule pull(body.direction, body.twist);
    for (std::size_t wall = 0; wall < body.wall_count(); ++wall) {
      const MotionRegion region = MotionRegion::wall(law, body, wall);
      for (std::size_t way = 0; way < 4; ++way) {
        const bool second = way % 2 == 1;
        DegreeProof proof = body;
        constexpr std::size_t kNodes = 300;
        degree_detail::WallRefuter& refuter =
            way < 2 ? static_cast<degree_detail::WallRefuter&>(by_law) : by_crowd;
        if (!refuter.refute(proof, wall, second, kNodes)) continue;
        ++seen[way];
        std::size_t next = 0;
        EXPECT_TRUE(is_refuted(law, region, proof.trees, next, second ? &pull : nullptr));
        EXPECT_EQ(next, proof.trees.size());
      }
    }
    EXPECT_GT(work.nodes, 0U);
  }
  for (const int count : seen) EXPECT_GE(count, 20);
  for (const int count : closed) EXPECT_GE(count, 2);
}

// Forces for people near an equilibrium balance its load, within cones.
TEST(NearForces, BalanceTheLoad) {
  RandomSource random(323);
  int count = 0;
  for (int round = 0; round < 30; ++round) {
    const GraspBox box = pinch(random);
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const RoundedGrasp grasp = rounded_middle(law);
    const std::vector<NearEquilibrium> found = Newton(grasp).solve_from(1);
    if (found.empty()) continue;
    ++count;
    Question question;
    question.grasp = box;
    const std::vector<SpatialForce> forces =
        near_forces(question, in_file(grasp, found.front().motion));
    ASSERT_EQ(forces.size(), 2U);
    std::vector<double> sum;
    for (const Interval& component : box.wrench) sum.push_back(to_double(component.low));
    for (std::size_t i = 0; i < 2; ++i) {
      const UncertainContact& c = box.contacts[i];
      const double x = to_double(forces[i].force[0]);
      const double y = to_double(forces[i].force[1]);
      sum[0] += x;
      sum[1] += y;
      sum[2] += to_double(c.position[0].low) * y - to_double(c.position[1].low) * x;
      const double normal = to_double(forces[i].normal);
      EXPECT_NEAR(x, normal * to_double(c.normal[0]), 1e-9);
      EXPECT_NEAR(normal, found.front().normal[i], 1e-6);
      EXPECT_LE(std::fabs(to_double(forces[i].friction[1])), 0.625 * normal + 1e-9);
    }
    for (const double left : sum) EXPECT_NEAR(left, 0, 1e-6);
  }
  EXPECT_GE(count, 20);
}

// Friction is against the slip, with all that it may have, also where nothing balances.
TEST(NearForces, OpposeTheSlip) {
  RandomSource random(324);
  for (int round = 0; round < 10; ++round) {
    GraspBox box = pinch(random);
    for (UncertainContact& c : box.contacts) c.position[1] = {};
    const int down = random.one_in(2) ? -1 : 1;
    box.wrench = {{}, point_interval(3 * down), {}};
    Question question;
    question.grasp = box;
    for (const SpatialForce& f : near_forces(question, {0, down, 0})) {
      EXPECT_NEAR(to_double(f.normal), 2, 1e-9);
      EXPECT_NEAR(to_double(f.friction[1]), -down * 0.625 * 2, 1e-9);
    }
  }
}

}  // namespace walls_test
}  // namespace stickslip
