// SPDX-License-Identifier: GPL-3.0-or-later
// Form closure, classes of loads, compliance and friction cones on the paper's grasps, with
// what the paper says of each; and degenerate grasps.
#include <gtest/gtest.h>

#include "engine/planar/find_flaw.hpp"
#include "paper_grasps.hpp"
#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/compliance.hpp"
#include "stickslip/earlier/form_closure.hpp"
#include "stickslip/earlier/friction_cones.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/engine/decide_problem.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {
namespace {

using test::fig1_grasp;
using test::fig4_grasp;
using test::RandomSource;

const Rational kHalf(1, 2);

Problem problem(const Grasp& grasp, const Wrench& w, NormalLaw law = NormalLaw::kUnilateral) {
  return Problem({grasp, w}, law);
}

bool is_weak(const Problem& p) {
  return std::holds_alternative<RigidForces>(weakly_stable_load(p));
}
bool is_frictionless(const Problem& p) {
  return std::holds_alternative<RigidForces>(frictionless_stable_load(p));
}
bool is_strong(const Problem& p) {
  return std::holds_alternative<StronglyStable>(strongly_stable_load(p));
}
bool linear_holds(const Problem& p) {
  const auto result = linear_compliance(p);
  const auto* balance = std::get_if<SpringBalance>(&result);
  return balance != nullptr && !balance->outside;
}
bool three_states_hold(const Problem& p) {
  return std::holds_alternative<SpringStates>(three_state_compliance(p));
}
bool cones_accept(const Problem& p) {
  return std::holds_alternative<Witness>(friction_cones_alone(p));
}
bool is_passive(const Problem& p) {
  return std::holds_alternative<Stable>(decide(p).verdict);
}

// "Contact forces always exist ... but, if the contacts have not been preloaded, these forces
// will not arise" (Section I, Fig. 1 left).
TEST(PaperClaims, Fig1UpwardsIsWeakButNotPassive) {
  const Problem p = problem(fig1_grasp(0), {0, 1, 0});
  EXPECT_TRUE(is_weak(p));
  EXPECT_FALSE(is_passive(p));
  EXPECT_FALSE(is_strong(p));
  EXPECT_FALSE(is_frictionless(p));
  EXPECT_FALSE(cones_accept(p));
}

// "The grasp in Fig. 1 for example is unstable in the frictionless case" (Section II), and has
// no form closure: it may be lifted out.
TEST(PaperClaims, Fig1WithoutFriction) {
  const Problem p = problem(fig1_grasp(1), {0, 1, 0});
  EXPECT_TRUE(is_passive(p));
  const auto closure = form_closure(p);
  ASSERT_TRUE(std::holds_alternative<FreeMotion>(closure));
  const LoadClass frictionless = frictionless_stable_load(p);
  ASSERT_TRUE(std::holds_alternative<UnopposedMotion>(frictionless));
  EXPECT_GT(std::get<UnopposedMotion>(frictionless).twist[1], 0);
  EXPECT_TRUE(is_frictionless(problem(fig1_grasp(1), {0, -1, 0})));
  EXPECT_TRUE(is_strong(problem(fig1_grasp(1), {0, -1, 0})));
}

// Fig. 3: "Since c_1 and c_3 now violate friction constraints, we could erroneously conclude
// that the disturbance can not be resisted."
TEST(PaperClaims, LinearFrictionRejectsFig3) {
  const Problem p = problem(fig1_grasp(0), {0, -1, 0});
  EXPECT_TRUE(is_passive(p));
  const auto result = linear_compliance(p);
  const auto& balance = std::get<SpringBalance>(result);
  EXPECT_EQ(balance.springs.twist, (Twist{0, Rational(-1, 3), 0}));
  ASSERT_TRUE(balance.outside);
  EXPECT_EQ(balance.outside->index(), 0u);
  EXPECT_EQ(balance.springs.forces[0].normal, 0);
  EXPECT_EQ(balance.springs.forces[0].tangential, Rational(1, 3));
  EXPECT_EQ(balance.springs.forces[1].normal, Rational(1, 3));
}

// "If we consider contacts 1 & 3 to be slipping, our grasp in Fig. 1 may now withstand
// arbitrary forces, where w_y <= 0" (Section VI).
TEST(PaperClaims, ThreeStatesHoldFig1Downwards) {
  for (const int preload : {0, 1}) {
    for (const Rational& down : {Rational(0), Rational(-1), Rational(-1000)}) {
      EXPECT_TRUE(three_states_hold(problem(fig1_grasp(preload), {0, down, 0})));
    }
  }
}

// "If we now apply an external wrench w = (0, 1, 0), there exists no combination of sticking,
// slipping and detached contacts ... Our algorithm, however, predicts a stable grasp" (P = 1).
TEST(PaperClaims, ThreeStatesRejectFig1Upwards) {
  const Problem p = problem(fig1_grasp(1), {0, 1, 0});
  EXPECT_TRUE(is_passive(p));
  const auto result = three_state_compliance(p);
  ASSERT_TRUE(std::holds_alternative<NoSpringStates>(result));
  EXPECT_EQ(std::get<NoSpringStates>(result).combinations, 27u);
  EXPECT_FALSE(linear_holds(p));
}

Grasp with_friction(const Grasp& grasp, const Rational& friction) {
  std::vector<Contact> contacts = grasp.contacts();
  for (Contact& c : contacts) c.friction = friction;
  return Grasp(std::move(contacts));
}

// Fig. 4: "Here, the existence problem (are there contact forces such that constraints (1)-(4)
// are satisfied) always has a solution, irrespective of the magnitude of the applied wrench, or
// the contact preload. The solution consists of a virtual object rotation". So it is for mu >
// 1, if contacts may open: a rotation r loads two opposite contacts with c_n = r each, whose
// torque 2 r only their friction can take up, since the load has none; what then is left of it
// balances the load.
TEST(PaperClaims, ConesAloneAcceptFig4WithMoreFriction) {
  for (const Rational& friction : {Rational(1) + parse_rational("1e-18"), Rational(2)}) {
    for (const Rational& up : {Rational(1), Rational(-2), Rational(100)}) {
      const Grasp grasp = with_friction(fig4_grasp(0), friction);
      const Problem p = problem(grasp, {0, up, 0});
      EXPECT_FALSE(is_passive(p));
      const ConesVerdict verdict = friction_cones_alone(p);
      ASSERT_TRUE(std::holds_alternative<Witness>(verdict));
      const Witness& witness = std::get<Witness>(verdict);
      EXPECT_NE(witness.twist.r, 0);
      const std::optional<std::string> violation = find_violation(p, witness);
      ASSERT_TRUE(violation);
      EXPECT_NE(violation->find("maximum dissipation"), std::string::npos);
      EXPECT_TRUE(cones_accept(problem(grasp.with_preload(1), {0, up, 0})));
      EXPECT_FALSE(cones_accept(problem(grasp, {0, up, 0}, NormalLaw::kBilateral)));
      EXPECT_FALSE(is_strong(p));
    }
  }
}

// For mu <= 1 friction cannot take up that torque, and with the mu = 1/2 of the paper's tables
// the friction cones alone do reject Fig. 4: the claim above does not hold for this grasp.
TEST(PaperClaims, ConesAloneRejectFig4AsTabulated) {
  for (const Rational& friction : {kHalf, Rational(1)}) {
    for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
      for (const Rational& up : {parse_rational("1e-18"), Rational(1), Rational(-2)}) {
        const Grasp grasp = with_friction(fig4_grasp(0), friction);
        const Problem p = problem(grasp, {0, up, 0}, law);
        EXPECT_TRUE(is_weak(p));
        const ConesVerdict verdict = friction_cones_alone(p);
        ASSERT_TRUE(std::holds_alternative<Trees>(verdict));
        EXPECT_EQ(find_flaw(p, std::get<Trees>(verdict)), std::nullopt);
      }
    }
  }
  // Nor beyond the 4 mu of the preloaded grasp.
  EXPECT_TRUE(cones_accept(problem(fig4_grasp(1), {0, 2, 0})));
  EXPECT_FALSE(cones_accept(problem(fig4_grasp(1), {0, 2 + parse_rational("1e-18"), 0})));
}

// A block on the floor between two contacts, pushed sideways within the cone: friction makes
// the load strong, which it is not without.
TEST(StrongStability, FrictionCanHoldWithoutPreload) {
  const Grasp floor({{{-1, -1}, {0, 1}, kHalf, 1, 0}, {{1, -1}, {0, 1}, kHalf, 1, 0}});
  const Problem held = problem(floor, {Rational(1, 4), -1, 0});
  EXPECT_TRUE(is_strong(held));
  EXPECT_FALSE(is_frictionless(held));
  const auto strong = strongly_stable_load(held);
  EXPECT_GE(std::get<StronglyStable>(strong).cases(), 2u);
  // On the border of the cone it still holds; beyond it slides.
  EXPECT_TRUE(is_strong(problem(floor, {kHalf, -1, 0})));
  EXPECT_FALSE(is_strong(problem(floor, {kHalf + parse_rational("1e-18"), -1, 0})));
}

// By load_classes.hpp the class between frictionless and weak depends on the mass matrix.
TEST(StrongStability, DependsOnTheMass) {
  RandomSource random(62);
  int differ = 0;
  for (int round = 0; round < 300; ++round) {
    const Grasp grasp = test::degenerate_grasp(random, 3);
    const Problem p = problem(grasp, test::small_wrench(random));
    const bool here = is_strong(p);
    const auto elsewhere = strongly_stable_load(p, {{3, -2}, {{Rational(1, 100)}}});
    differ += here != std::holds_alternative<StronglyStable>(elsewhere) ? 1 : 0;
  }
  EXPECT_GT(differ, 0);
}

TEST(StrongStability, RefusesNoMassAndKeepsTheLimit) {
  EXPECT_THROW(strongly_stable_load(problem(Grasp(), {}), {{0, 0}, {{0}}}), ContractError);
  const auto limited = strongly_stable_load(problem(fig1_grasp(0), {0, 1, 0}), {}, 0);
  EXPECT_TRUE(std::holds_alternative<Undecided>(limited));
}

// All contacts at one point: no spring resists a rotation about it.
TEST(Degenerate, ContactsAtOnePoint) {
  const Grasp corner(
      {{{1, 1}, {1, 0}, 1, 1, 1}, {{1, 1}, {0, 1}, 1, 2, 1}, {{1, 1}, {-1, 0}, 1, 1, 1}});
  const Problem through = problem(corner, {0, -1, -1});  // a force through the point
  const auto held = linear_compliance(through);
  EXPECT_TRUE(std::holds_alternative<SpringBalance>(held));
  const auto turned = linear_compliance(problem(corner, {0, -1, 0}));
  ASSERT_TRUE(std::holds_alternative<UnresistedMotion>(turned));
  EXPECT_NE(std::get<UnresistedMotion>(turned).motion[2], 0);
}

// Contacts in one place multiply the patterns of separation but not the regions.
TEST(Degenerate, ManyContactsInOnePlaceStayCheap) {
  std::vector<Contact> contacts;
  for (int i = 0; i < 24; ++i) contacts.push_back({{-1, 0}, {1, 0}, kHalf, 1, 1});
  for (int i = 0; i < 24; ++i) contacts.push_back({{1, 0}, {-1, 0}, kHalf, 1, 1});
  const ConesVerdict verdict = friction_cones_alone(problem(Grasp(contacts), {0, 25, 0}), 50);
  EXPECT_FALSE(std::holds_alternative<Undecided>(verdict));
}

// A row of contacts on the floor: all slip planes are one.
TEST(Degenerate, ManyContactsOnOneFloorStayCheap) {
  std::vector<Contact> contacts;
  for (int i = 0; i < 40; ++i) contacts.push_back({{i - 20, -1}, {0, 1}, kHalf, 1, 0});
  const auto held =
      strongly_stable_load(problem(Grasp(contacts), {Rational(1, 4), -1, 0}), {}, 50);
  EXPECT_TRUE(std::holds_alternative<StronglyStable>(held));
  const auto slides = strongly_stable_load(problem(Grasp(contacts), {1, -1, 0}), {}, 50);
  EXPECT_TRUE(std::holds_alternative<Acceleration>(slides));
}

TEST(Limits, AreReported) {
  std::vector<Contact> contacts(12, {{1, 0}, {-1, 0}, kHalf, 1, 0});
  const auto states = three_state_compliance(problem(Grasp(contacts), {1, 0, 0}));
  ASSERT_TRUE(std::holds_alternative<Undecided>(states));
  EXPECT_NE(std::get<Undecided>(states).limit.find("3^12"), std::string::npos);
  EXPECT_TRUE(std::holds_alternative<Undecided>(
      friction_cones_alone(problem(fig1_grasp(0), {0, 1, 0}), 0)));
}

// No subset of three or four normals positively spans: by brute force over the motions that two
// contacts' borders leave, and the axes of the kernel.
bool has_form_closure_by_motions(const Problem& p) {
  std::vector<IntegerVector<3>> normals;
  for (const ContactRow& row : p.rows()) {
    normals.push_back(primitive_multiple(coordinates(row.normal)));
  }
  const auto is_free = [&](const IntegerVector<3>& d) {
    for (const IntegerVector<3>& n : normals) {
      if (dot(n, d).sign() < 0) return false;
    }
    return true;
  };
  // If the cone of free motions is not {0}, it has a line, found with the kernel's axes below,
  // or an extreme ray: orthogonal to two independent normals.
  std::vector<IntegerVector<3>> generators = normals;
  for (const IntegerVector<3>& axis : {IntegerVector<3>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    generators.push_back(axis);
  }
  for (const IntegerVector<3>& a : generators) {
    for (const IntegerVector<3>& b : generators) {
      const IntegerVector<3> d = cross(a, b);
      if (!is_zero(d) && is_free(d)) return false;
    }
  }
  return true;
}

TEST(FormClosure, AgreesWithBruteForce) {
  RandomSource random(61);
  int closed = 0;
  constexpr int kRounds = 400;
  for (int round = 0; round < kRounds; ++round) {
    const auto m = static_cast<std::size_t>(random.between(0, 7));
    const Grasp grasp =
        round % 2 == 0 ? test::degenerate_grasp(random, m) : test::generic_grasp(random, m);
    const Problem p = problem(grasp, {});
    const bool found = std::holds_alternative<FormClosure>(form_closure(p));
    EXPECT_EQ(found, has_form_closure_by_motions(p)) << test::describe({{grasp, {}}, {}});
    closed += found ? 1 : 0;
  }
  EXPECT_GE(closed, kRounds / 10);
  EXPECT_LE(closed, kRounds / 2);
}

}  // namespace
}  // namespace stickslip
