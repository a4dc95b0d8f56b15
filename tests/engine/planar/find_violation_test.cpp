// SPDX-License-Identifier: GPL-3.0-or-later
// Each condition of an equilibrium, broken alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "paper_grasps.hpp"
#include "random_grasps.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;

const Rational kHalf(1, 2);

/// Table I, sixth row: contact 2 opens, contacts 1 and 3 slip.
Problem table_row(NormalLaw law = NormalLaw::kUnilateral) {
  return Problem({test::fig1_grasp(1), {0, 1, 0}}, law);
}
Witness table_witness() {
  return {{0, 1, 0}, {{1, -kHalf}, {0, 0}, {1, kHalf}}};
}

TEST(FindViolation, AnEquilibriumHasNone) {
  EXPECT_EQ(find_violation(table_row(), table_witness()), std::nullopt);
  EXPECT_EQ(find_violation(table_row(NormalLaw::kBilateral), table_witness()), std::nullopt);
}

TEST(FindViolation, NumberOfForces) {
  Witness witness = table_witness();
  witness.forces.pop_back();
  EXPECT_THAT(find_violation(table_row(), witness),
              Optional(HasSubstr("one force per contact")));
  witness.forces.resize(4);
  EXPECT_THAT(find_violation(table_row(), witness),
              Optional(HasSubstr("one force per contact")));
}

TEST(FindViolation, NormalLaw) {
  Witness witness = table_witness();
  witness.forces[0].normal += Rational(1, Integer("1000000000000000000"));
  EXPECT_THAT(find_violation(table_row(), witness),
              Optional(HasSubstr("normal law fails at contact 0")));
  witness = table_witness();
  witness.forces[2].normal = -1;
  EXPECT_THAT(find_violation(table_row(), witness),
              Optional(HasSubstr("normal law fails at contact 2")));
}

TEST(FindViolation, OnlyTheUnilateralLawOpensContacts) {
  Witness witness = table_witness();
  witness.twist.y = 2;  // v = -1 at contact 2
  EXPECT_EQ(find_violation(table_row(), witness), std::nullopt);
  EXPECT_THAT(find_violation(table_row(NormalLaw::kBilateral), witness),
              Optional(HasSubstr("normal law fails at contact 1")));
  // c_n = v < 0 is an equilibrium under neither law.
  witness.forces[1].normal = -1;
  for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
    EXPECT_THAT(find_violation(table_row(law), witness),
                Optional(HasSubstr("normal law fails at contact 1")));
  }
}

TEST(FindViolation, FrictionCone) {
  // Fig. 4, P = 1, d = 0: friction is free in its cone, and no further.
  const Problem problem({test::fig4_grasp(1), {0, 2, 0}}, NormalLaw::kUnilateral);
  Witness witness{{}, {{1, -kHalf}, {1, -kHalf}, {1, kHalf}, {1, kHalf}}};
  EXPECT_EQ(find_violation(problem, witness), std::nullopt);
  for (const int sign : {-1, 1}) {
    Witness outside = witness;
    outside.forces[1].tangential = Rational(sign) * Rational(51, 100);
    EXPECT_THAT(find_violation(problem, outside),
                Optional(HasSubstr("friction cone fails at contact 1")));
  }
}

TEST(FindViolation, MaximumDissipation) {
  // Contact 1 slips along t = (0, 1): friction inside the cone, or on its other edge, is wrong.
  for (const Rational& friction : {Rational(0), kHalf, Rational(-49, 100)}) {
    Witness witness = table_witness();
    witness.forces[0].tangential = friction;
    EXPECT_THAT(find_violation(table_row(), witness),
                Optional(HasSubstr("dissipation fails at contact 0")));
    witness = table_witness();
    witness.forces[2].tangential = -friction;
    EXPECT_THAT(find_violation(table_row(), witness),
                Optional(HasSubstr("dissipation fails at contact 2")));
  }
}

TEST(FindViolation, EachComponentOfTheBalance) {
  const Rational tiny(1, Integer("1000000000000000000"));
  for (const Wrench& extra : {Wrench{tiny, 0, 0}, Wrench{0, -tiny, 0}, Wrench{0, 0, tiny}}) {
    const Problem problem({test::fig1_grasp(1), Wrench{0, 1, 0} + extra},
                          NormalLaw::kUnilateral);
    EXPECT_THAT(find_violation(problem, table_witness()), Optional(HasSubstr("balance")));
  }
}

TEST(FindViolation, NoContacts) {
  EXPECT_EQ(find_violation(Problem({Grasp(), {}}, NormalLaw::kUnilateral), {}), std::nullopt);
  EXPECT_THAT(find_violation(Problem({Grasp(), {0, 0, 1}}, NormalLaw::kUnilateral), {}),
              Optional(HasSubstr("balance")));
}

TEST(FindViolation, ForcesAreCoefficientsOfTheNormalAsGiven) {
  // L = 5, P = 10, d = 0: the coefficient is P / L = 2.
  const Problem problem({Grasp({{{0, 0}, {0, 5}, 0, 1, 10}}), {0, -10, 0}},
                        NormalLaw::kUnilateral);
  EXPECT_EQ(find_violation(problem, {{}, {{2, 0}}}), std::nullopt);
  EXPECT_THAT(find_violation(problem, {{}, {{10, 0}}}), Optional(HasSubstr("normal law")));
}

}  // namespace
}  // namespace stickslip
