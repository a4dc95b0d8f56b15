// SPDX-License-Identifier: GPL-3.0-or-later
// The earlier methods against Z3, whose formulas are written from the contacts alone.
#include <gtest/gtest.h>

#include <iostream>

#include "engine/planar/find_flaw.hpp"
#include "paper_grasps.hpp"
#include "smt_oracle.hpp"
#include "stickslip/earlier/compliance.hpp"
#include "stickslip/earlier/friction_cones.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/engine/decide_problem.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {
namespace {

using test::LoadCase;
using test::Model;
using test::RandomSource;

bool accepts(const Problem& p, Model model, const Inertia& inertia = {}) {
  switch (model) {
    case Model::kPassive:
      return std::holds_alternative<Stable>(decide(p).verdict);
    case Model::kConesAlone: {
      const ConesVerdict verdict = friction_cones_alone(p);
      EXPECT_FALSE(std::holds_alternative<Undecided>(verdict));
      if (const auto* tree = std::get_if<Trees>(&verdict)) {
        EXPECT_EQ(find_flaw(p, *tree), std::nullopt);
      }
      return std::holds_alternative<Witness>(verdict);
    }
    case Model::kWeak:
      return std::holds_alternative<RigidForces>(weakly_stable_load(p));
    case Model::kFrictionless:
      return std::holds_alternative<RigidForces>(frictionless_stable_load(p));
    case Model::kAccelerates: {
      const auto result = strongly_stable_load(p, inertia);
      EXPECT_FALSE(std::holds_alternative<Undecided>(result));
      return std::holds_alternative<Acceleration>(result);
    }
    case Model::kLinearSprings: {
      const auto result = linear_compliance(p);
      const auto* balance = std::get_if<SpringBalance>(&result);
      return balance != nullptr && !balance->outside;
    }
    default:
      return std::holds_alternative<SpringStates>(three_state_compliance(p));
  }
}

Grasp random_grasp(RandomSource& random, int round) {
  const auto m = static_cast<std::size_t>(random.between(round % 8 == 0 ? 0 : 1, 5));
  return round % 3 == 0 ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
}

/// Loads of all kinds: far off, on borders, without normal forces, and held.
std::vector<LoadCase> random_cases(std::uint64_t seed, int count) {
  RandomSource random(seed);
  std::vector<LoadCase> result;
  for (int round = 0; round < count; ++round) {
    Grasp grasp = random_grasp(random, round);
    const NormalLaw law = round % 4 == 0 ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const int kind = random.between(0, 3);
    const Wrench w = kind == 0   ? test::small_wrench(random)
                     : kind == 1 ? test::planted_wrench(random, grasp, law)
                     : kind == 2
                         ? test::threshold_wrench(
                               random, grasp, random.one_in(2) ? 0 : parse_rational("1e-12"))
                         : Rational(1, 4) * test::small_wrench(random);
    // Threshold loads lie on the border of the cones at d = 0; without preload on that of 0.
    result.push_back({{std::move(grasp), w}, law});
  }
  return result;
}

void expect_agreement(Model model, const char* name, const std::vector<LoadCase>& load_cases) {
  const std::vector<std::string> expected = test::ask_z3(load_cases, model);
  std::size_t yes = 0;
  for (std::size_t i = 0; i < load_cases.size(); ++i) {
    const bool found = accepts(Problem(load_cases[i].loaded, load_cases[i].law), model);
    EXPECT_EQ(found ? "stable" : "unstable", expected[i]) << name << '\n'
                                                          << describe(load_cases[i]);
    yes += found ? 1 : 0;
  }
  std::cout << name << ": " << load_cases.size() << " questions, " << yes << " solvable\n";
  EXPECT_GE(12 * yes, load_cases.size());
  EXPECT_LE(12 * yes, 11 * load_cases.size());
}

TEST(EarlierMethodsAgainstZ3, WeaklyStable) {
  expect_agreement(Model::kWeak, "weakly stable", random_cases(71, 300));
}
TEST(EarlierMethodsAgainstZ3, FrictionlessStable) {
  expect_agreement(Model::kFrictionless, "frictionless stable", random_cases(72, 300));
}
TEST(EarlierMethodsAgainstZ3, StronglyStable) {
  expect_agreement(Model::kAccelerates, "not strongly stable", random_cases(73, 300));
}
// In a frame about the centre of mass, and in units of the radius of gyration, inertia is unit.
TEST(EarlierMethodsAgainstZ3, StronglyStableWithOtherMasses) {
  const Vector2 centre{Rational(3, 2), Rational(-2, 3)};
  std::size_t differ = 0;
  for (const Rational& gyration : {Rational(1, 5), Rational(4)}) {
    std::vector<LoadCase> in_units = random_cases(82, 120);
    const std::vector<std::string> expected = test::ask_z3(in_units, Model::kAccelerates);
    for (std::size_t i = 0; i < in_units.size(); ++i) {
      std::vector<Contact> contacts = in_units[i].loaded.grasp.contacts();
      for (Contact& c : contacts) {
        c.position = {centre.x + gyration * c.position.x, centre.y + gyration * c.position.y};
      }
      const Wrench& w = in_units[i].loaded.wrench;
      const Wrench load{w.x, w.y, gyration * w.torque + centre.x * w.y - centre.y * w.x};
      const Problem p({Grasp(contacts), load}, NormalLaw::kUnilateral);
      const bool moves =
          accepts(p, Model::kAccelerates, {{centre.x, centre.y}, {{gyration * gyration}}});
      EXPECT_EQ(moves ? "stable" : "unstable", expected[i]) << describe(in_units[i]);
      differ += moves != accepts(p, Model::kAccelerates) ? 1 : 0;
    }
  }
  EXPECT_GT(differ, 0u);  // or the masses would not matter
}
TEST(EarlierMethodsAgainstZ3, LinearCompliance) {
  expect_agreement(Model::kLinearSprings, "linear compliance", random_cases(74, 300));
}
TEST(EarlierMethodsAgainstZ3, ThreeStates) {
  expect_agreement(Model::kThreeStates, "three states", random_cases(75, 200));
}
TEST(EarlierMethodsAgainstZ3, ConesAlone) {
  expect_agreement(Model::kConesAlone, "friction cones alone", random_cases(76, 300));
}

// Where the paper's claim on Fig. 4 holds and where it does not (earlier_methods_test.cpp).
TEST(EarlierMethodsAgainstZ3, ConesAloneOnFig4) {
  std::vector<LoadCase> load_cases;
  for (const char* friction : {"0.5", "1", "1.000000000001", "2"}) {
    for (const int preload : {0, 1}) {
      std::vector<Contact> contacts = test::fig4_grasp(preload).contacts();
      for (Contact& c : contacts) c.friction = parse_rational(friction);
      for (const int up : {1, -2, 5}) {
        for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
          load_cases.push_back({{Grasp(contacts), {0, up, 0}}, law});
        }
      }
    }
  }
  expect_agreement(Model::kConesAlone, "friction cones alone, Fig. 4", load_cases);
}

}  // namespace
}  // namespace stickslip
