// SPDX-License-Identifier: GPL-3.0-or-later
// Newton's method, and exact programs in its modes, on a pinch whose equilibrium is known.
#include "engine/degree/newton.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "engine/degree/mode_program.hpp"

namespace stickslip {
namespace {

/// Two pads of stiffness 1 press with 2 from the left and the right at a distance of 1.
GraspBox pinch(const Rational& friction, const RationalRow& wrench) {
  GraspBox box;
  for (const int side : {-1, 1}) {
    UncertainContact& c = box.contacts.emplace_back();
    c.position = {point_interval(side), point_interval(0)};
    c.normal = {-side, 0};
    c.friction = point_interval(friction);
    c.preload = point_interval(2);
  }
  for (const Rational& w : wrench) box.wrench.push_back(point_interval(w));
  return box;
}

const Rational kHalf(1, 2);
constexpr double kNearly = 1e-9;

// A push of f moves the body by f/2, so that pads press with 2 - f/2 and 2 + f/2; each carries
// half of the weight, and nothing slips.
void expect_pushed(const NearEquilibrium& near, double push) {
  EXPECT_NEAR(near.motion[0], push / 2, kNearly);
  EXPECT_NEAR(near.motion[1], 0, kNearly);
  EXPECT_NEAR(near.motion[2], 0, kNearly);
  EXPECT_NEAR(near.normal[0], 2 - push / 2, kNearly);
  EXPECT_NEAR(near.normal[1], 2 + push / 2, kNearly);
  EXPECT_NEAR(near.friction[0][0], 0.25, kNearly);
  EXPECT_NEAR(near.friction[1][0], -0.25, kNearly);
}

TEST(Newton, FindsPolishesAndFollowsThePinch) {
  const GraspLaw law(pinch(kHalf, {1, -kHalf, 0}), NormalLaw::kUnilateral);
  const RoundedGrasp grasp = rounded_middle(law);
  const Newton newton(grasp);
  const std::vector<NearEquilibrium> found = newton.solve_from(3);
  ASSERT_FALSE(found.empty());
  expect_pushed(found.front(), 1);
  NearEquilibrium off = found.front();
  off.motion[0] += 0.125;
  off.motion[1] -= 0.25;
  off.friction[0][0] = 0;
  const auto polished = newton.polish(off);
  ASSERT_TRUE(polished);
  expect_pushed(*polished, 1);
  const GraspLaw other(pinch(kHalf, {Rational(6, 5), -kHalf, 0}), NormalLaw::kUnilateral);
  const RoundedGrasp pushed = rounded_middle(other);
  const auto followed = Newton(pushed).follow(found.front());
  ASSERT_TRUE(followed);
  expect_pushed(*followed, 1.2);
}

// It finds it from far off as well, where no pad touches. What slides for ever has none.
TEST(Newton, FindsThePinchSmoothly) {
  const GraspLaw law(pinch(kHalf, {1, -kHalf, 0}), NormalLaw::kUnilateral);
  const RoundedGrasp grasp = rounded_middle(law);
  for (const double far : {0.0, 3.0, -8.0}) {
    const auto found = Newton(grasp).solve_smoothly(Reals::Constant(3, far));
    ASSERT_TRUE(found) << far;
    expect_pushed(*found, 1);
  }
  const GraspLaw heavy(pinch(kHalf, {0, Rational(-21, 10), 0}), NormalLaw::kUnilateral);
  const RoundedGrasp falls = rounded_middle(heavy);
  EXPECT_FALSE(Newton(falls).solve_smoothly(Reals::Zero(3)));
}

// Pads of friction 1/2 carry 2 in all.
TEST(Newton, FindsNothingBeyondWhatFrictionCarries) {
  for (const auto& [weight, holds] :
       {std::pair{Rational(19, 10), true}, {Rational(21, 10), false}}) {
    const GraspLaw law(pinch(kHalf, {0, -weight, 0}), NormalLaw::kUnilateral);
    const RoundedGrasp grasp = rounded_middle(law);
    const NearEquilibrium rest{Reals::Zero(3), {2, 2}, {{}, {}}, {1, 1}};
    EXPECT_EQ(Newton(grasp).polish(rest).has_value(), holds);
  }
}

// Springs answer by their stiffness, 2 in all, and friction by mu a over the size of slips.
TEST(Newton, AnswersByStiffnessAndFriction) {
  for (const int has_friction : {0, 1}) {
    const GraspLaw law(pinch(has_friction * kHalf, {0, 0, 0}), NormalLaw::kUnilateral);
    const RoundedGrasp grasp = rounded_middle(law);
    const Eigen::MatrixXd answer = Newton(grasp).answer(Reals::Zero(3), 0.1);
    EXPECT_NEAR(answer(0, 0), 2, kNearly);
    EXPECT_NEAR(answer(1, 1), has_friction * 20, kNearly);
    EXPECT_NEAR(answer(0, 1), 0, kNearly);
  }
}

// A stiffer pad rubs more against the same slip as it is pressed: with smooth friction of mu a
// over the size of slips, a slip of s up takes mu s k / size from what each pad pushes up.
TEST(Newton, AnswersByFrictionAgainstTheSlip) {
  GraspBox box = pinch(kHalf, {0, 0, 0});
  box.contacts[1].stiffness = point_interval(3);
  const GraspLaw law(box, NormalLaw::kUnilateral);
  const RoundedGrasp grasp = rounded_middle(law);
  Reals up = Reals::Zero(3);
  up[1] = 0.01;
  const Eigen::MatrixXd answer = Newton(grasp).answer(up, 0.1);
  EXPECT_NEAR(answer(1, 0), 0.5 * 0.01 / 0.1 * (3 - 1), kNearly);
  EXPECT_NEAR(answer(1, 1), 20, kNearly);
}

// Pads carry 2 of a weight of 3 while the body slides down onto a spring, by 1.
TEST(Newton, SlidesUntilASpringCarriesTheRest) {
  GraspBox box = pinch(kHalf, {0, -3, 0});
  UncertainContact& floor = box.contacts.emplace_back();
  floor.position = {point_interval(0), point_interval(-1)};
  floor.normal = {0, 1};
  floor.friction = point_interval(0);
  const GraspLaw law(box, NormalLaw::kUnilateral);
  const RoundedGrasp grasp = rounded_middle(law);
  const auto found = Newton(grasp).solve(Reals::Zero(3));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->motion[1], -1, 1e-6);
  EXPECT_NEAR(found->normal[2], 1, 1e-6);
  EXPECT_NEAR(found->friction[0][0], 1, 1e-6);
  EXPECT_NEAR(found->friction[1][0], -1, 1e-6);
  EXPECT_EQ(found->sticks, (std::vector<char>{0, 0, 0}));
}

// The equations are linear here once modes are given: one step balances.
TEST(ModalEquations, OneStepBalancesThePinch) {
  const GraspLaw law(pinch(kHalf, {1, -kHalf, 0}), NormalLaw::kUnilateral);
  const RoundedGrasp grasp = rounded_middle(law);
  NearEquilibrium near{Reals::Zero(3), {0, 0}, {{}, {}}, {1, 1}};
  const ModalEquations equations(grasp, near);
  EXPECT_NEAR(equations.off()[0], 1, kNearly);
  EXPECT_NEAR(equations.off()[1], -0.5, kNearly);
  const Reals step = equations.motion_change(equations.off(), equations.slips());
  EXPECT_NEAR(step[0], 0.5, kNearly);
  EXPECT_NEAR(step[1], 0, kNearly);
  const Eigen::VectorXd friction = equations.friction_change(equations.off(), step);
  EXPECT_NEAR(friction[0], 0.25, kNearly);
  EXPECT_NEAR(friction[1], -0.25, kNearly);
}

// The exact equilibrium in the modes of one in doubles that is somewhat off: friction is 1/3 of
// 3/4 at the one pad and 1/5 of 5/4 at the other, against the weight.
TEST(ModeProgram, FindsTheExactEquilibriumOfItsModes) {
  const GraspLaw law(pinch(kHalf, {1, -kHalf, 0}), NormalLaw::kUnilateral);
  NearEquilibrium near{Reals::Zero(3), {1.5, 2.5}, {{0.2}, {-0.3}}, {1, 1}};
  near.motion[0] = 0.49;
  const auto witness = degree_detail::equilibrium_in_modes(law, near);
  ASSERT_TRUE(witness);
  EXPECT_EQ(witness->twist, (RationalRow{kHalf, 0, 0}));
  ASSERT_EQ(witness->shares.size(), 2U);
  EXPECT_EQ(witness->shares[0].second, RationalRow{Rational(1, 3)});
  EXPECT_EQ(witness->shares[1].second, RationalRow{Rational(-1, 5)});
  const GraspLaw heavy(pinch(kHalf, {0, -3, 0}), NormalLaw::kUnilateral);
  EXPECT_FALSE(degree_detail::equilibrium_in_modes(heavy, near));
}

}  // namespace
}  // namespace stickslip
