// SPDX-License-Identifier: GPL-3.0-or-later
// The search for trees, on laws of any number of coordinates that no grasp file can say. Planar
// grasps are judged by another engine, and trees about them by find_flaw(), which knows nothing
// of this search.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/planar/find_flaw.hpp"
#include "engine/search/law_forces.hpp"
#include "random_grasps.hpp"
#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/branch_and_bound.hpp"

namespace stickslip {
namespace {

using test::RandomSource;

/// Columns of an embedding: a row a of Q^3 becomes M a.
using Embedding = std::vector<std::array<int, 3>>;

const Embedding kPlane{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
/// x, y and the rotation about z of a body in space.
const Embedding kSpace{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}};
/// Dense.
const Embedding kNine{{1, 0, 0}, {0, 1, 0},  {0, 0, 1},  {1, 1, 0}, {0, 1, -1},
                      {2, 0, 1}, {-1, 1, 1}, {1, -2, 0}, {1, 1, 1}};

RationalRow embedded(const Embedding& m, const Wrench& row) {
  RationalRow result;
  for (const auto& [x, y, r] : m) result.emplace_back(x * row.x + y * row.y + r * row.torque);
  return result;
}

Law law_of(const Problem& problem, const Embedding& m) {
  Law law;
  law.motions = m.size();
  law.rotates.assign(m.size(), 0);  // of toys all coordinates are alike
  law.normal_law = problem.law();
  for (const Rational& w : embedded(m, problem.wrench())) {
    law.wrench.push_back(point_interval(w));
  }
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.row(ContactId(i));
    LawContact& contact = law.contacts.emplace_back();
    contact.friction = point_interval(row.friction);
    contact.preload = point_interval(row.preload);
    contact.stiffness = point_interval(row.stiffness);
    CornerRow& corner = contact.corners.emplace_back();
    corner.normal = embedded(m, row.normal);
    corner.set_slip({embedded(m, row.tangent)}, 1);
  }
  law.complete(0);
  return law;
}

struct Outcome {
  bool refuted = false;
  SearchEnd end = SearchEnd::kNone;
  Trees tree;
};

Outcome search(const Law& law, const MotionRegion& region) {
  Outcome outcome;
  SearchWork work;
  constexpr std::size_t kNodes = 2000;
  LawSearch tree_search(law, nullptr, kNodes, work);
  outcome.refuted = tree_search.refute(region, outcome.tree);
  outcome.end = tree_search.end();
  return outcome;
}

/// Of a tree in the plane, or of one whose other coordinates nothing sees.
Trees in_plane(const Trees& tree, const std::array<std::size_t, 3>& coordinates) {
  const auto three = [&](const Row& row) -> Row {
    return {row[coordinates[0]], row[coordinates[1]], row[coordinates[2]]};
  };
  Trees result;
  for (const TreeNode& node : tree) {
    if (const auto* slip = std::get_if<SlipSplit>(&node)) result.emplace_back(*slip);
    if (const auto* split = std::get_if<SeparationSplit>(&node)) result.emplace_back(*split);
    if (const auto* cut = std::get_if<PlaneCut>(&node)) {
      const Row d = three(cut->plane);
      const std::size_t h = cut->plane.size() - 2;
      result.emplace_back(PlaneCut{{d[0], d[1], d[2], cut->plane[h], 0}});
    }
    if (const auto* leaf = std::get_if<TwistLeaf>(&node)) {
      result.emplace_back(TwistLeaf{three(leaf->twist)});
    }
  }
  return result;
}

TEST(TreeSearch, EmbeddedGraspsHaveTheVerdictOfTheOtherEngine) {
  RandomSource random(34);
  std::array<int, 2> seen{};
  for (int round = 0; round < 150; ++round) {
    const auto contacts = static_cast<std::size_t>(random.between(2, 5));
    const Grasp grasp = round % 2 == 0 ? test::generic_grasp(random, contacts)
                                       : test::degenerate_grasp(random, contacts);
    const NormalLaw law = round % 3 == 0 ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const Wrench load =
        round % 5 < 3 ? test::small_wrench(random) : test::planted_wrench(random, grasp, law);
    const Problem problem(LoadedGrasp{grasp, load}, law);
    const Verdict verdict = branch_and_bound(problem);
    const bool stable = std::holds_alternative<Stable>(verdict);
    ++seen[stable ? 1 : 0];
    for (const Embedding* m : {&kPlane, &kSpace, &kNine}) {
      const Law embedded_law = law_of(problem, *m);
      const Outcome outcome = search(embedded_law, MotionRegion::root(embedded_law));
      EXPECT_EQ(outcome.refuted, !stable) << m->size() << test::describe({{grasp, load}, law});
      if (!outcome.refuted || m == &kNine) continue;
      const std::array<std::size_t, 3> coordinates{0, 1, m->size() - 1};
      const auto flaw = find_flaw(problem, in_plane(outcome.tree, coordinates));
      EXPECT_FALSE(flaw.has_value()) << m->size() << *flaw;
    }
  }
  EXPECT_GE(seen[0], 40);
  EXPECT_GE(seen[1], 40);
}

/// One coordinate: springs along a line, whose balance is known without any search.
Law line_of(const std::vector<std::array<int, 3>>& springs, const Rational& load) {
  Law law;
  law.motions = 1;
  law.rotates = {0};
  law.wrench = {point_interval(load)};
  for (const auto& [normal, preload, friction] : springs) {
    LawContact& contact = law.contacts.emplace_back();
    contact.friction = point_interval(friction);
    contact.preload = point_interval(preload);
    contact.stiffness = point_interval(1);
    CornerRow& corner = contact.corners.emplace_back();
    corner.normal = {normal};
    corner.set_slip({{1}}, 1);
  }
  law.complete(0);
  return law;
}

TEST(TreeSearch, ASpringAlongALinePushesOneWayOnly) {
  const std::vector<std::array<int, 3>> one{{1, 0, 0}};
  for (const int load : {-2, 0}) {
    const Law law = line_of(one, load);
    EXPECT_FALSE(search(law, MotionRegion::root(law)).refuted) << load;
  }
  const Law pulled = line_of(one, 1);
  const Outcome outcome = search(pulled, MotionRegion::root(pulled));
  ASSERT_TRUE(outcome.refuted);
  // All along it: the load does work, and a contact that is open or pushes does not hold it.
  for (const TreeNode& node : outcome.tree) {
    const auto* leaf = std::get_if<TwistLeaf>(&node);
    if (leaf != nullptr && !is_zero(leaf->twist)) {
      EXPECT_LT(leaf->twist[0], 0);
    }
  }
}

/// Between two springs with preload 1 that push against each other, d = load / 2 while both
/// touch, |load| <= 2, and |d| = |load| - 1 beyond.
TEST(TreeSearch, AWallIsRefutedWhereNoEquilibriumLiesOnIt) {
  for (int load = -6; load <= 6; ++load) {
    const Law law = line_of({{1, 1, 0}, {-1, 1, 0}}, Rational(load, 2));
    const Rational at = abs(load) <= 4 ? Rational(load, 4)
                        : load > 0     ? Rational(load, 2) - 1
                                       : Rational(load, 2) + 1;
    for (int place = -8; place <= 8; ++place) {
      // Walls at place / 4 - 1 and place / 4 + 1.
      ConvexBody body;
      body.twist = {Rational(place, 4)};
      body.walls = {{1}};
      for (const std::size_t wall : {0U, 1U}) {
        const Rational here = body.twist[0] + (wall == 0 ? 1 : -1);
        EXPECT_EQ(search(law, MotionRegion::wall(law, body, wall)).refuted, here != at)
            << load << " " << here;
      }
    }
  }
}

TEST(TreeSearch, SaysWhatEndedIt) {
  const Law law = line_of({{1, 1, 0}, {-1, 1, 0}}, 0);
  SearchWork work;
  Trees tree;
  LawSearch none(law, nullptr, 0, work);
  EXPECT_FALSE(none.refute(MotionRegion::root(law), tree));
  EXPECT_EQ(none.end(), SearchEnd::kNodes);
  EXPECT_EQ(work.nodes, 0U);
  LawSearch some(law, nullptr, 100, work);
  some.on_candidate([](const NearEquilibrium& near) {
    constexpr double kNear = 1e-6;
    return std::fabs(near.motion[0]) < kNear;
  });
  EXPECT_FALSE(some.refute(MotionRegion::root(law), tree));
  EXPECT_EQ(some.end(), SearchEnd::kCandidate);
}

/// Interval loads: refuted only if no load of the interval has an equilibrium.
TEST(TreeSearch, ABoxOfLoadsIsRefutedAsAWhole) {
  for (const auto& [low, high, refuted] :
       {std::tuple{1, 2, true}, {0, 2, false}, {-2, 1, false}, {-2, -1, false}}) {
    Law law = line_of({{1, 0, 0}}, 0);
    law.wrench = {{low, high}};
    law.complete(0);
    EXPECT_EQ(search(law, MotionRegion::root(law)).refuted, refuted) << low << " " << high;
  }
}

/// Corners and directions of loads on a line, with what a strict function is there.
struct Hull {
  std::vector<std::array<int, 2>> corners;
  std::vector<std::array<int, 2>> directions;
};

Law with_hull(Law law, const Hull& hull) {
  law.wrench = {point_interval(0)};
  LoadHull& loads = law.hull.emplace();
  for (const auto& [load, strict] : hull.corners) loads.corners.push_back({{load}, {strict}});
  for (const auto& [load, strict] : hull.directions) {
    loads.directions.push_back({{load}, {strict}});
  }
  law.complete_loads();
  return law;
}

TEST(TreeSearch, AHullOfLoadsIsRefutedAsAWhole) {
  const Law spring = line_of({{1, 0, 0}}, 0);
  for (const auto& [hull, refuted] :
       std::vector<std::pair<Hull, bool>>{{{{{1, 1}, {2, 1}}, {}}, true},
                                          {{{{-1, 1}, {2, 1}}, {}}, false},
                                          {{{{1, 1}}, {{1, 1}}}, true},
                                          {{{{1, 1}}, {{-1, 1}}}, false}}) {
    const Law law = with_hull(spring, hull);
    EXPECT_EQ(search(law, MotionRegion::root(law)).refuted, refuted);
  }
}

// Two corners, the first without the second function and the other without the first; and a
// direction without the first.
TEST(LoadHull, BarsWhereAFunctionIsZeroOnAllThatCount) {
  const LoadHull corners{{{{1, 0}, {1, 0}}, {{1, 1}, {0, 1}}}, {}};
  LoadHull hull = corners;
  hull.directions = {{{0, -1}, {0, 1}}};
  for (const auto& [y, with_corners, bars] : {std::tuple{Row{1, 0}, true, false},
                                              {Row{1, 0}, false, true},
                                              {Row{1, 1}, true, true},
                                              {Row{1, 1}, false, true}}) {
    EXPECT_EQ(hull.bars(y, with_corners), bars) << y[1];
    EXPECT_EQ(corners.bars(y, with_corners), bars) << y[1];
  }
  EXPECT_TRUE(corners.bars({1, -1}, true));  // the second is 0 at the one that does the most
}

/// No load is 0 where a strict function is, and only what is exact knows.
TEST(TreeSearch, AsksWhatIsExactBesideAnEquilibrium) {
  const Law spring = line_of({{1, 0, 0}}, 0);
  for (const Hull& hull :
       {Hull{{{0, 0}, {1, 1}}, {}}, Hull{{{0, 0}}, {{1, 1}}}, Hull{{{0, 1}, {1, 1}}, {}}}) {
    const Law law = with_hull(spring, hull);
    const bool has_zero = hull.corners.front() == std::array{0, 1};
    for (const int twist : {-1, 1}) {
      SearchWork work;
      Trees tree;
      LawSearch tree_search(law, nullptr, 100, work);
      int asked = 0;
      tree_search.on_doubt([&](const MotionRegion&) {
        ++asked;
        return std::optional<TreeNode>(TwistLeaf{{twist}});
      });
      const bool is_true = twist < 0 && !has_zero;
      if (is_true) {
        EXPECT_TRUE(tree_search.refute(MotionRegion::root(law), tree));
      } else {
        EXPECT_THROW(tree_search.refute(MotionRegion::root(law), tree), ContractError);
      }
      EXPECT_GE(asked, 1);
    }
  }
}

}  // namespace
}  // namespace stickslip
