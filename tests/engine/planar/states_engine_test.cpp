// SPDX-License-Identifier: GPL-3.0-or-later
// Small grasps whose verdict can be derived by hand, and random ones whose evidence is judged.
#include "stickslip/engine/states_engine.hpp"

#include <gtest/gtest.h>

#include "engine/planar/find_flaw.hpp"
#include "judged.hpp"
#include "paper_grasps.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/refutation_summary.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {
namespace {

using test::judged_verdict;
using test::judged_verdicts;
using test::q;
using test::RandomSource;

/// Contact i of `contacts` with mu = 1/2, k = 1 and preload P.
Grasp grasp_of(const std::vector<std::pair<Vector2, Vector2>>& contacts,
               const Rational& preload) {
  std::vector<Contact> result;
  for (const auto& [position, normal] : contacts) {
    result.push_back({position, normal, Rational(1, 2), 1, preload});
  }
  return Grasp(std::move(result));
}

Grasp with_friction(const Grasp& grasp, const Rational& friction) {
  std::vector<Contact> contacts = grasp.contacts();
  for (Contact& c : contacts) c.friction = friction;
  return Grasp(std::move(contacts));
}

TEST(Frictionless, FingersResistOnlyAlongTheirNormals) {
  const Grasp pinch = with_friction(grasp_of({{{-1, 0}, {1, 0}}, {{1, 0}, {-1, 0}}}, 1), 0);
  EXPECT_EQ(judged_verdicts({pinch, {0, 0, 0}}), "stable");
  EXPECT_EQ(judged_verdicts({pinch, {2, 0, 0}}), "stable");
  EXPECT_EQ(judged_verdicts({pinch, {0, q("1e-18"), 0}}), "unstable");
  EXPECT_EQ(judged_verdicts({pinch, {0, 0, 1}}), "unstable");
  // d = (x, 0, 0): the second finger loses its preload at x = 1, w_x = 2.
  EXPECT_EQ(judged_verdicts({pinch, {q("2.000000000000000001"), 0, 0}}),
            "unilateral stable, bilateral unstable");
}

TEST(Frictionless, FormClosureHoldsEverything) {
  // Four fingers that push counterclockwise and clockwise in pairs.
  const Grasp square = with_friction(grasp_of({{{-2, 1}, {1, 0}},
                                               {{2, -1}, {-1, 0}},
                                               {{-1, -2}, {0, 1}},
                                               {{1, 2}, {0, -1}},
                                               {{-2, -1}, {1, 0}},
                                               {{2, 1}, {-1, 0}}},
                                              0),
                                     0);
  for (const Wrench& w :
       {Wrench{5, 0, 0}, Wrench{-1, 3, 2}, Wrench{0, 0, -7}, Wrench{1, 1, 1}}) {
    EXPECT_EQ(judged_verdict({{square, w}, NormalLaw::kUnilateral}), "stable");
  }
}

TEST(Work, CountsTheStatesOfThePaper) {
  StatesWork work;
  decide_by_states(Problem({test::fig1_grasp(0), {0, 1, 0}}, NormalLaw::kUnilateral), &work);
  EXPECT_EQ(work.states, 27u);
  EXPECT_EQ(work.states_refuted, 27u);
  EXPECT_GE(work.programs, 1u);
  decide_by_states(Problem({test::fig4_grasp(0), {0, 2, 0}}, NormalLaw::kUnilateral), &work);
  EXPECT_EQ(work.states, 9u);
  EXPECT_EQ(work.states_refuted, 9u);
}

/// The cases of an unstable load's proof.
std::size_t cases_of(const Problem& problem, StatesWork& work) {
  const Verdict verdict = decide_by_states(problem, &work);
  return summarize(std::get<Unstable>(verdict).tree).leaves;
}

// The README's first example: one twist for all states but those of two groups.
TEST(Work, OneTwistRefutesAGroupOfStates) {
  StatesWork work;
  const LoadedGrasp pulled{test::fig1_grasp(1), {0, q("11/10"), 0}};
  EXPECT_EQ(cases_of(Problem(pulled, NormalLaw::kUnilateral), work), 3u);
  EXPECT_EQ(work.states_refuted, 27u);
  EXPECT_EQ(work.states_solved, 1u);
  EXPECT_EQ(work.programs, 6u);
  EXPECT_EQ(judged_verdict({pulled, NormalLaw::kUnilateral}), "unstable");
}

TEST(Work, ATwistIsCarriedFromAStateToAll) {
  StatesWork work;
  const LoadedGrasp tilted{test::fig1_grasp(1), {0, 2, 1}};
  EXPECT_EQ(cases_of(Problem(tilted, NormalLaw::kBilateral), work), 1u);
  EXPECT_EQ(work.states_refuted, 27u);
  EXPECT_EQ(work.programs, 1u);
  EXPECT_EQ(work.twists_carried, 1u);
}

// Six contacts in general position have 123 states, most of which need no look of their own.
TEST(Work, IsSharedByManyStates) {
  RandomSource random(61);
  std::size_t states = 0;
  std::size_t solved = 0;
  std::size_t programs = 0;
  std::size_t refuted = 0;
  std::size_t cases = 0;
  for (int round = 0; round < 40; ++round) {
    const Problem problem({test::generic_grasp(random, 6), test::small_wrench(random)},
                          NormalLaw::kUnilateral);
    StatesWork work;
    const Verdict verdict = decide_by_states(problem, &work);
    states += work.states;
    solved += work.states_solved;
    programs += work.programs;
    if (!std::holds_alternative<Unstable>(verdict)) continue;
    refuted += work.states_refuted;
    cases += cases_of(problem, work);
  }
  EXPECT_LT(3 * programs, states);
  EXPECT_LT(20 * solved, states);
  EXPECT_GE(refuted, 300u);
  EXPECT_LT(5 * cases, refuted);
}

// The walkers that judge all refutations must themselves reject: every node dropped, and the
// load turned round.
TEST(CheckRefutation, RejectsMutations) {
  const Problem problem({test::fig1_grasp(0), {0, 1, 0}}, NormalLaw::kUnilateral);
  const Trees refutation = std::get<Unstable>(decide_by_states(problem)).tree;
  const auto holds = [](const Problem& of, const Trees& tree) {
    const bool by_twin = !test::check_refutation(of, tree);
    EXPECT_EQ(by_twin, !find_flaw(of, tree));
    return by_twin;
  };
  ASSERT_TRUE(holds(problem, refutation));
  for (std::size_t drop = 0; drop < refutation.size(); ++drop) {
    Trees shorter = refutation;
    shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(drop));
    EXPECT_FALSE(holds(problem, shorter)) << drop;
  }
  Trees longer = refutation;
  longer.emplace_back(TwistLeaf{Row(3)});
  EXPECT_FALSE(holds(problem, longer));
  EXPECT_EQ(test::check_refutation(problem, longer),
            "node " + std::to_string(refutation.size() - 1) + ": tree-long");
  const Problem held({test::fig1_grasp(0), {0, -1, 0}}, NormalLaw::kUnilateral);
  EXPECT_FALSE(holds(held, refutation));
  EXPECT_FALSE(holds(problem, {}));
  EXPECT_FALSE(holds(problem, {TwistLeaf{Row(3)}}));
  EXPECT_FALSE(holds(problem, {SlipSplit{ContactId(3)}}));
  EXPECT_THROW(validate(problem, Unstable{longer}), ContractError);
  EXPECT_THROW(validate(problem, Stable{Witness{}}), ContractError);
  EXPECT_NO_THROW(validate(problem, Unstable{refutation}));
}

// Refutations judged without Cone as well: rays by brute force over the constraints.
TEST(Refutations, HoldWithRaysFoundByBruteForce) {
  RandomSource random(41);
  int unstable = 0;
  for (int round = 0; round < 60; ++round) {
    const auto m = static_cast<std::size_t>(random.between(1, 3));
    const Grasp grasp =
        random.one_in(2) ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
    const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const test::LoadCase load_case{{grasp, test::small_wrench(random)}, law};
    unstable += judged_verdict(load_case, test::RaysFrom::kBruteForce) == "unstable" ? 1 : 0;
  }
  EXPECT_GE(unstable, 20);
}

TEST(Larger, FiveToSevenContacts) {
  RandomSource random(51);
  int stable = 0;
  constexpr int kRounds = 16;
  for (int round = 0; round < kRounds; ++round) {
    const auto m = static_cast<std::size_t>(random.between(5, 7));
    const Grasp grasp =
        round % 2 == 0 ? test::degenerate_grasp(random, m) : test::generic_grasp(random, m);
    Wrench w = test::small_wrench(random);
    if (round % 4 >= 2) w = test::threshold_wrench(random, grasp, q("1e-12"));
    stable += judged_verdicts({grasp, w}) != "unstable" ? 1 : 0;
  }
  EXPECT_GE(stable, 2);
  EXPECT_LE(stable, kRounds - 2);
}

}  // namespace
}  // namespace stickslip
