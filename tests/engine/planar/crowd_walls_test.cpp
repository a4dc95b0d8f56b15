// SPDX-License-Identifier: GPL-3.0-or-later
// Trees that refute walls around an equilibrium, node by node by the letter of the format.
#include "engine/planar/crowd_walls.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "naive_region.hpp"
#include "random_grasps.hpp"
#include "stickslip/engine/pull_rule.hpp"

namespace stickslip {
namespace crowd_walls_test {

using test::NaiveRegion;
using test::RandomSource;
using test::Rays;

/// A box of motions around one.
ConvexBody box_around(const Twist& d, const Rational& size) {
  ConvexBody body;
  body.twist = {d.x, d.y, d.r};
  for (std::size_t j = 0; j < 3; ++j) {
    body.walls.emplace_back(3);
    body.walls[j][j] = 1 / size;
  }
  return body;
}

/// E.(d - h d0) - height h as a function of points.
Vector5 plane(const ConvexBody& body, std::size_t j, int height) {
  const RationalRow& e = body.walls[j];
  return {e[0], e[1], e[2], -dot(e, body.twist) - height, 0};
}

NaiveRegion wall_of(const Problem& problem, const ConvexBody& body, std::size_t wall) {
  NaiveRegion region;
  const Vector5 h{0, 0, 0, 1, 0};
  region.constraints = {{h, 1}, {{0, 0, 0, 0, 1}, 0}};
  region.strict.push_back(h);
  region.labels.resize(problem.size());
  for (std::size_t j = 0; j < 3; ++j) {
    if (j == wall / 2) {
      region.constraints.push_back({plane(body, j, wall % 2 == 0 ? 1 : -1), 0});
    } else {
      region.constraints.push_back({plane(body, j, 1), -1});
      region.constraints.push_back({plane(body, j, -1), 1});
    }
  }
  return region;
}

/// Reads one tree, and returns how many leaves are no proof. `pull` has the rows of A(d - h
/// d0).
std::size_t flaws(const Problem& problem, const NaiveRegion& region, const Trees& tree,
                  std::size_t& next, const std::vector<RationalRow>& pull) {
  if (next >= tree.size()) return 1;
  const TreeNode& node = tree[next++];
  std::vector<NaiveRegion> children;
  if (const auto* slip = std::get_if<SlipSplit>(&node)) {
    for (const int sign : {1, 0, -1}) {
      children.push_back(region.slip_child(problem, slip->contact.index(), sign));
    }
  } else if (const auto* split = std::get_if<SeparationSplit>(&node)) {
    for (const bool closed : {true, false}) {
      children.push_back(region.separation_child(problem, split->contact.index(), closed));
    }
  } else if (const auto* cut = std::get_if<PlaneCut>(&node)) {
    const Vector5 function = test::to_rational(vector_of<5>(cut->plane));
    for (const bool first : {true, false})
      children.push_back(region.plane_child(function, first));
  } else {
    const auto& leaf = std::get<TwistLeaf>(node);
    const Rays rays = brute_force_generators(region.constraints).directions();
    if (naive_is_barred(region, rays)) return 0;
    if (!naive_refutes(problem, region, rays, leaf)) return 1;
    for (const Vector5& x : rays) {
      Rational along = 0;
      for (std::size_t j = 0; j < pull.size(); ++j) {
        for (std::size_t k = 0; k < 5; ++k)
          along += Rational(leaf.twist[j]) * pull[j][k] * x[k];
      }
      if (along.sign() < 0) return 1;
    }
    return 0;
  }
  std::size_t sum = 0;
  for (const NaiveRegion& child : children) sum += flaws(problem, child, tree, next, pull);
  return sum;
}

struct Balanced {
  Problem problem;
  Twist at;
};

/// Preloaded grasps with an equilibrium.
Balanced balanced(RandomSource& random) {
  for (;;) {
    const Grasp grasp =
        test::generic_grasp(random, static_cast<std::size_t>(random.between(2, 4)));
    Problem problem(
        LoadedGrasp{grasp, test::planted_wrench(random, grasp, NormalLaw::kUnilateral)},
        NormalLaw::kUnilateral);
    const Verdict verdict = branch_and_bound(problem);
    const Stable& stable = std::get<Stable>(verdict);
    if (std::holds_alternative<Witness>(stable.proof)) return {problem, stable.witness().twist};
  }
}

TEST(CrowdWalls, TreesRefuteWalls) {
  RandomSource random(111);
  int refuted = 0;
  int pulled = 0;
  int closed = 0;
  constexpr std::size_t kNodes = 200;
  for (int round = 0; round < 40; ++round) {
    const auto [problem, d] = balanced(random);
    CrowdWalls walls(problem);
    EXPECT_EQ(&walls.problem(), &problem);
    const ConvexBody body = box_around(d, Rational(1, random.between(2, 20)));
    // How springs answer a motion, as all contacts are closed at rest.
    std::vector<RationalRow> pull(3, RationalRow(5));
    for (const ContactRow& row : problem.rows()) {
      const Vector3 n = coordinates(row.normal);
      const Rational k = row.stiffness;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          pull[i][j] -= k * n[i] * n[j];
          pull[i][3] += k * n[i] * n[j] * body.twist[j];
        }
      }
    }
    const PullRule rule(pull);
    for (std::size_t wall = 0; wall < 6; ++wall) {
      const NaiveRegion naive = wall_of(problem, body, wall);
      const Region region = Region::wall(problem, body, wall);
      const Rays rays = brute_force_generators(naive.constraints).directions();
      bool are_closed = true;
      for (std::size_t i = 0; i < problem.size(); ++i) {
        for (const Vector5& x : rays) {
          are_closed =
              are_closed && test::value_at(problem.separation(ContactId(i)), x).sign() >= 0;
        }
      }
      EXPECT_EQ(walls.all_are_closed(region), are_closed);
      closed += are_closed ? 1 : 0;
      for (const PullRule* with : {static_cast<const PullRule*>(nullptr), &rule}) {
        Trees tree;
        if (!walls.refute(region, with, kNodes, tree)) continue;
        ++(with != nullptr ? pulled : refuted);
        std::size_t next = 0;
        EXPECT_EQ(flaws(problem, naive, tree, next,
                        with != nullptr ? pull : std::vector<RationalRow>{}),
                  0U);
        EXPECT_EQ(next, tree.size());
      }
    }
    // No tree refutes a wall through an equilibrium.
    Twist beside = d;
    beside.y += Rational(1, 4);
    Trees tree;
    EXPECT_FALSE(walls.refute(Region::wall(problem, box_around(beside, Rational(1, 4)), 3),
                              nullptr, kNodes, tree));
  }
  EXPECT_GE(refuted, 60);
  EXPECT_GE(pulled, 10);
  EXPECT_GE(closed, 10);
}

// Newton's method mostly returns an equilibrium: forces of springs, friction within its cone
// and against the slip, and all of it in balance with the load.
TEST(CrowdWalls, NearEquilibriaBalance) {
  RandomSource random(112);
  int right = 0;
  constexpr double kNearly = 1e-6;
  constexpr int kRounds = 100;
  for (int round = 0; round < kRounds; ++round) {
    const auto [problem, d] = balanced(random);
    const double length = random.between(1, 3);
    bool is_right = false;
    for (const NearEquilibrium& near : CrowdWalls(problem).newton_equilibria(3, length)) {
      const double x = near.motion[0];
      const double y = near.motion[1];
      const double r = near.motion[2] / length;
      const auto work = [&](const Wrench& w) {
        return to_double(w.x) * x + to_double(w.y) * y + to_double(w.torque) * r;
      };
      std::array<double, 3> sum{to_double(problem.wrench().x), to_double(problem.wrench().y),
                                to_double(problem.wrench().torque)};
      bool is_lawful = true;
      for (std::size_t i = 0; i < problem.size(); ++i) {
        const ContactRow& row = problem.rows()[i];
        const double v = to_double(row.preload) - to_double(row.stiffness) * work(row.normal);
        const double a = near.normal[i];
        const double b = near.friction[i][0];
        const double most = to_double(row.friction) * a;
        const double slip = work(row.tangent);
        is_lawful = is_lawful && std::fabs(a - std::max(0.0, v)) < kNearly &&
                    std::fabs(b) <= most + kNearly &&
                    b * slip <= -most * std::fabs(slip) + kNearly;
        sum[0] += a * to_double(row.normal.x) + b * to_double(row.tangent.x);
        sum[1] += a * to_double(row.normal.y) + b * to_double(row.tangent.y);
        sum[2] += a * to_double(row.normal.torque) + b * to_double(row.tangent.torque);
      }
      for (const double left : sum) is_lawful = is_lawful && std::fabs(left) < kNearly;
      is_right = is_right || is_lawful;
    }
    right += is_right ? 1 : 0;
  }
  EXPECT_GE(right, kRounds / 2);
}

}  // namespace crowd_walls_test
}  // namespace stickslip
