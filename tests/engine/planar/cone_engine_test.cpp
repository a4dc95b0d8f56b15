// SPDX-License-Identifier: GPL-3.0-or-later
// What judged_verdict does not cover: determinism, limits, counters, and grasps whose numbers
// leave double precision behind. Verdicts are judged in every other test of this folder.
#include <gtest/gtest.h>

#include "both_checkers.hpp"
#include "judged.hpp"
#include "loads.hpp"
#include "paper_grasps.hpp"
#include "rounds.hpp"
#include "stickslip/engine/decide_problem.hpp"
#include "stickslip/engine/newton_equilibria.hpp"
#include "stickslip/engine/refutation_summary.hpp"

namespace stickslip::test {
namespace {

/// `count` contacts on part of a circle, and a load that pulls the object off them or presses
/// it on.
LoadedGrasp arc(std::size_t count, std::uint64_t seed, bool pulled_off) {
  RandomSource random(seed);
  std::vector<Contact> contacts;
  Vector2 sum;
  for (std::size_t i = 0; i < count; ++i) {
    const Rational t(random.between(-48, 48), 64);
    const Rational scale = 1 + t * t;
    Contact c;
    c.normal = {(t * t - 1) / scale, -2 * t / scale};
    c.position = {-c.normal.x + Rational(random.between(-10, 10), 100),
                  -c.normal.y + Rational(random.between(-10, 10), 100)};
    c.friction = Rational(random.between(0, 8), 10);
    c.stiffness = random.between(1, 5);
    c.preload = Rational(random.between(1, 4), 4);
    sum.x += c.normal.x * c.preload;
    sum.y += c.normal.y * c.preload;
    contacts.push_back(std::move(c));
  }
  const Rational pull = pulled_off ? Rational(1, 2) : Rational(-9, 10);
  return {Grasp(std::move(contacts)),
          {pull * sum.x, pull * sum.y, Rational(static_cast<long>(count), 50)}};
}

TEST(ConeEngine, SameAnswerEveryTime) {
  for (const bool pulled_off : {false, true}) {
    const Problem problem(arc(600, 1, pulled_off), NormalLaw::kUnilateral);
    std::vector<std::string> texts;
    std::vector<std::vector<std::pair<std::string, std::size_t>>> works;
    for (int time = 0; time < 2; ++time) {
      BranchWork work;
      const Verdict verdict = branch_and_bound(problem, {}, &work);
      if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
        texts.push_back(to_text(unstable->tree));
      } else {
        const Witness& witness = std::get<Stable>(verdict).witness();
        EXPECT_EQ(find_violation(problem, witness), std::nullopt);
        texts.push_back(to_string(witness.twist.x) + to_string(witness.twist.y) +
                        to_string(witness.twist.r));
      }
      works.push_back(counters(work));
    }
    EXPECT_EQ(texts[0], texts[1]);
    EXPECT_EQ(works[0], works[1]);
    BranchWork work;
    branch_and_bound(problem, {}, &work);
    // Every contact once, and every group of some.
    EXPECT_LE(work.visits, 2 * work.nodes * problem.size());
  }
}

TEST(ConeEngine, ManyContactsWithBothVerdictsJudged) {
  int stable = 0;
  int unstable = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const bool pulled_off : {false, true}) {
      const LoadedGrasp loaded = arc(60, seed, pulled_off);
      const Problem problem(loaded, NormalLaw::kUnilateral);
      const Verdict verdict = branch_and_bound(problem);
      expect_accepted_by_both(loaded, NormalLaw::kUnilateral, verdict);
      if (const auto* found = std::get_if<Unstable>(&verdict)) {
        ++unstable;
        EXPECT_EQ(check_refutation(problem, found->tree), std::nullopt);
      } else {
        ++stable;
        EXPECT_EQ(find_violation(problem, std::get<Stable>(verdict).witness()), std::nullopt);
      }
    }
  }
  EXPECT_GE(stable, 1);
  EXPECT_GE(unstable, 1);
}

TEST(ConeEngine, GivesUpOnlyAtItsLimit) {
  const Problem problem({fig1_grasp(1), {0, Rational(11, 10), 0}}, NormalLaw::kUnilateral);
  BranchWork whole;
  ASSERT_TRUE(std::holds_alternative<Unstable>(branch_and_bound(problem, {}, &whole)));
  SearchOptions options;
  for (std::size_t limit = 1; limit <= whole.nodes; ++limit) {
    options.node_limit = limit;
    const Verdict verdict = branch_and_bound(problem, options);
    if (limit < whole.nodes) {
      ASSERT_TRUE(std::holds_alternative<Undecided>(verdict)) << limit;
      EXPECT_EQ(std::get<Undecided>(verdict).limit,
                "the search reached the limit of " + std::to_string(limit) + " nodes");
    } else {
      EXPECT_TRUE(std::holds_alternative<Unstable>(verdict));
    }
  }
}

TEST(ConeEngine, CountersAddUp) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    BranchWork work;
    const Verdict verdict =
        branch_and_bound(Problem(arc(40, seed, true), NormalLaw::kUnilateral), {}, &work);
    const auto* unstable = std::get_if<Unstable>(&verdict);
    ASSERT_NE(unstable, nullptr);
    EXPECT_EQ(work.nodes, unstable->tree.size());
    EXPECT_EQ(work.nodes, work.leaves + work.voids + work.slip_splits + work.separation_splits);
    EXPECT_EQ(work.nodes, 1 + 3 * work.slip_splits + 2 * work.separation_splits);
    EXPECT_EQ(work.leaves, work.filter_hits + work.filter_misses);
  }
}

// Planted loads have an equilibrium, but Newton's method may end beside its mode: what is left
// is found near there, not by going through thousands of regions.
TEST(ConeEngine, FindsEquilibriaOfManyContactsInFewRegions) {
  std::size_t instances = 0;
  std::size_t nodes = 0;
  for (const bench::Instance& instance :
       bench::stable_instances(1000, rounds(2 * bench::kStableFamilies))) {
    const Problem problem = problem_of(instance.question);
    if (has_long_equilibria(problem)) continue;
    BranchWork work;
    EXPECT_TRUE(std::holds_alternative<Stable>(branch_and_bound(problem, {}, &work)))
        << instance.family;
    ++instances;
    nodes += work.nodes;
  }
  EXPECT_GE(instances, rounds(20U));
  EXPECT_LE(nodes, 800U);  // 527
}

/// Fig. 1 with its parts scaled apart, so that doubles cannot see the answer; the threshold
/// stays 1.
LoadedGrasp spread_fig1(const Rational& stiffness_ratio, const Rational& load) {
  const Grasp plain = fig1_grasp(1);
  std::vector<Contact> contacts = plain.contacts();
  contacts[0].stiffness = stiffness_ratio;
  contacts[2].stiffness = stiffness_ratio;
  return {Grasp(std::move(contacts)), {0, load, 0}};
}

TEST(ConeEngine, ExactWhereDoublesGiveOut) {
  const Rational tiny(1, Integer(stickslip::pow(Integer(10), 40)));
  for (const char* ratio : {"1e-9", "1", "1e9", "1e30"}) {
    const Rational k = parse_rational(ratio);
    EXPECT_EQ(judged_verdict({spread_fig1(k, 1), NormalLaw::kUnilateral}), "stable") << ratio;
    EXPECT_EQ(judged_verdict({spread_fig1(k, 1 + tiny), NormalLaw::kUnilateral}), "unstable")
        << ratio;
  }
}

// Normals that vanish as doubles, with coefficients of forces that do not: what doubles lose of
// the one is multiplied by the other. Two facing frictionless contacts, pressed by what one of
// them holds.
TEST(ConeEngine, WhatUnderflowsDecidesNothing) {
  for (const char* length : {"1e-350", "1e-320", "1e-200", "1e200", "1e320"}) {
    const Rational l = parse_rational(length);
    const Rational force = parse_rational("1e-100");
    const Grasp grasp(
        {{{0, -1}, {0, l}, 0, force, force}, {{0, 1}, {0, Rational(-l)}, 0, force, force}});
    EXPECT_EQ(judged_verdicts({grasp, {0, Rational(-force), 0}}), "stable") << length;
    EXPECT_EQ(judged_verdicts({grasp, {0, Rational(-force), force}}), "unstable") << length;
  }
}

using Magnitudes = std::vector<const char*>;

void judge_mixed_magnitudes(const Magnitudes& magnitudes) {
  RandomSource random(5);
  for (int round = 0; round < 40; ++round) {
    std::vector<Contact> contacts;
    for (int i = 0; i < 4; ++i) {
      const auto spread = [&] { return parse_rational(random.pick(magnitudes)); };
      Contact c;
      c.position = {Rational(random.between(-3, 3)), Rational(random.between(-3, 3))};
      static const int kAxes[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
      const int* axis = kAxes[random.between(0, 3)];
      const Rational length = spread();
      c.normal = {length * axis[0], length * axis[1]};
      c.friction = Rational(random.between(0, 2), 2);
      c.stiffness = spread();
      c.preload = random.one_in(2) ? Rational(0) : spread();
      contacts.push_back(std::move(c));
    }
    const Wrench load{Rational(random.between(-2, 2)), Rational(random.between(-2, 2)),
                      Rational(random.between(-2, 2))};
    judged_verdicts({Grasp(std::move(contacts)), load});
  }
}

// Each contact's numbers differ from the next one's by many orders of magnitude.
TEST(ConeEngine, MotionsWhoseSquaresOverflow) {
  const Rational soft = parse_rational("1e-160");
  const Grasp grasp({{{9, -9}, {1, 0}, 2, 2 * soft, 0},
                     {{6, -5}, {-4, -3}, 0, 5 * soft, 2},
                     {{-6, -2}, {-4, -3}, Rational(1, 2), 4 * soft, 3},
                     {{-1, 1}, {3, 4}, Rational(1, 3), 5 * soft, 0},
                     {{4, 4}, {4, 3}, 1, 2 * soft, 0}});
  EXPECT_EQ(judged_verdict({{grasp, {-2, -2, -8}}, NormalLaw::kUnilateral}), "stable");
}

TEST(ConeEngine, MixedMagnitudes) {
  judge_mixed_magnitudes({"1e-9", "1", "1e9"});
}

TEST(ConeEngine, MixedMagnitudesBeyondDoubles) {
  judge_mixed_magnitudes({"1e-330", "1e-170", "1", "1e170", "1e330"});
}

TEST(Decide, TakesTheConeEngineUnlessAskedForTheOther) {
  const Problem problem(LoadedGrasp{fig1_grasp(1), {0, 1, 0}}, NormalLaw::kUnilateral);
  EXPECT_STREQ(decide(problem).engine(), "branch-and-bound");
  EXPECT_STREQ(decide(problem, by(Engine::kStates)).engine(), "states");
}

TEST(Decide, SummaryNamesTheLargestCase) {
  const Trees tree{SlipSplit{ContactId(2)}, SeparationSplit{ContactId(0)},
                   TwistLeaf{{1, 0, 0}},    TwistLeaf{{2, 0, 0}},
                   TwistLeaf{Row(3)},       TwistLeaf{{3, 0, 0}}};
  const RefutationSummary summary = summarize(tree);
  EXPECT_EQ(summary.nodes, 6u);
  EXPECT_EQ(summary.leaves, 3u);
  EXPECT_EQ(summary.largest_leaf, std::vector<std::string>{"contact 2 slips -"});
  EXPECT_EQ(summary.largest_leaf_twist[0], 3);
  const std::map<ContactId, Sign> slips{{ContactId(2), Sign::kNegative}};
  EXPECT_TRUE(summary.largest_leaf_slips == slips);
  EXPECT_TRUE(summary.largest_leaf_open.empty());
}

TEST(Decide, SummaryShowsTheCaseThatLooksLikeTheFailure) {
  LoadedGrasp loaded;
  loaded.grasp =
      Grasp(std::vector<Contact>{{{0, 0}, {1, 0}, Rational(1, 2)}});  // tangent (0, 1)
  const Problem problem(loaded, NormalLaw::kUnilateral);
  const TwistLeaf up{{0, -1, 0}};  // what the object does is against the twist
  const Trees slips{SlipSplit{ContactId(0)}, TwistLeaf{{0, 1, 0}}, up, up};
  EXPECT_EQ(summarize(slips, &problem).largest_leaf[0], "contact 0 slips +");
  const Trees swapped{SlipSplit{ContactId(0)}, TwistLeaf{Row(3)}, up, TwistLeaf{{0, 2, 0}}};
  EXPECT_EQ(summarize(swapped, &problem).largest_leaf[0], "contact 0 slips -");
  EXPECT_EQ(summarize(swapped, &problem).largest_leaf_twist[1], 2);
  EXPECT_EQ(summarize(swapped).largest_leaf[0], "contact 0 sticks");
  const Trees opens{SeparationSplit{ContactId(0)}, up, TwistLeaf{{-1, 0, 0}}};
  EXPECT_EQ(summarize(opens, &problem).largest_leaf[0], "contact 0 is open");
  EXPECT_EQ(summarize(opens, &problem).leaves, 2u);
}

TEST(Decide, SummaryKnowsWhichContactsAreOpen) {
  const Trees tree{SlipSplit{ContactId(2)}, TwistLeaf{Row(3)},    SeparationSplit{ContactId(0)},
                   TwistLeaf{Row(3)},       TwistLeaf{{1, 0, 0}}, TwistLeaf{Row(3)}};
  const RefutationSummary summary = summarize(tree);
  const std::map<ContactId, Sign> slips{{ContactId(2), Sign::kZero}};
  EXPECT_TRUE(summary.largest_leaf_slips == slips);
  EXPECT_TRUE(summary.largest_leaf_open == std::set<ContactId>{ContactId(0)});
}

}  // namespace
}  // namespace stickslip::test
