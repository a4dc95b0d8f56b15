// SPDX-License-Identifier: GPL-3.0-or-later
// Haas-Heger et al., RSS 2018, Tables I and III. The tables print one solution of each row; an
// engine may find another. So the printed one must be an equilibrium, and so must the engine's.
#include <gtest/gtest.h>

#include <algorithm>

#include "judged.hpp"
#include "paper_grasps.hpp"

namespace stickslip {
namespace {

using test::fig1_grasp;
using test::fig4_grasp;
using test::judged_verdict;
using test::q;

struct TableRow {
  Wrench wrench;
  int preload;
  bool stable;
  Witness printed;        ///< if stable
  bool bilateral_stable;  ///< by the literal Eqs. 2 and 4
};

void expect_row(const Grasp& grasp, const TableRow& row) {
  const LoadedGrasp loaded{grasp, row.wrench};
  for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
    SCOPED_TRACE(test::describe({loaded, law}));
    const bool stable = law == NormalLaw::kUnilateral ? row.stable : row.bilateral_stable;
    EXPECT_EQ(judged_verdict({loaded, law}), stable ? "stable" : "unstable");
    if (row.stable) {
      EXPECT_EQ(find_violation(Problem(loaded, law), row.printed) == std::nullopt, stable);
    }
  }
}

TEST(TableI, EveryRow) {
  const Rational half(1, 2);
  const TableRow rows[] = {
      {{0, 0, 0}, 0, true, {{0, 0, 0}, {{0, 0}, {0, 0}, {0, 0}}}, true},
      {{0, 0, 0}, 1, true, {{0, 0, 0}, {{1, -half}, {1, 0}, {1, half}}}, true},
      {{0, -1, 0}, 0, true, {{0, -1, 0}, {{0, 0}, {1, 0}, {0, 0}}}, true},
      {{0, -2, 0}, 0, true, {{0, -2, 0}, {{0, 0}, {2, 0}, {0, 0}}}, true},
      {{0, 1, 0}, 0, false, {}, false},
      {{0, 1, 0}, 1, true, {{0, 1, 0}, {{1, -half}, {0, 0}, {1, half}}}, true},
      {{0, q("1.1"), 0}, 1, false, {}, false},
  };
  for (const TableRow& row : rows) expect_row(fig1_grasp(row.preload), row);
}

TEST(TableI, TheMotionIsNotUnique) {
  const Rational half(1, 2);
  const Problem problem({fig1_grasp(1), {0, 1, 0}}, NormalLaw::kUnilateral);
  for (const char* y : {"0.999999", "1", "1.000001", "1000000"}) {
    const Witness witness{{0, q(y), 0}, {{1, -half}, {0, 0}, {1, half}}};
    EXPECT_EQ(find_violation(problem, witness) == std::nullopt, q(y) >= 1) << y;
  }
}

TEST(TableIII, EveryRow) {
  const Rational half(1, 2);
  const TableRow rows[] = {
      {{0, 0, 0}, 0, true, {{0, 0, 0}, {{0, 0}, {0, 0}, {0, 0}, {0, 0}}}, true},
      {{0, 0, 0}, 1, true, {{0, 0, 0}, {{1, 0}, {1, 0}, {1, 0}, {1, 0}}}, true},
      {{0, 2, 0}, 0, false, {}, false},
      {{0, -2, 0}, 0, false, {}, false},
      {{0, 2, 0}, 1, true, {{0, 0, 0}, {{1, -half}, {1, -half}, {1, half}, {1, half}}}, true},
      {{0, -2, 0}, 1, true, {{0, 0, 0}, {{1, half}, {1, half}, {1, -half}, {1, -half}}}, true},
      // Printed with f1 = f3 = (0, 0.5), outside the cone; (1, 0.5) is meant. Contacts 2 and 4
      // are off, which the literal Eqs. 2 and 4 exclude.
      {{0, 0, 3}, 0, true, {{0, -1, 1}, {{1, half}, {0, 0}, {1, half}, {0, 0}}}, false},
      {{0, 0, -3}, 0, true, {{0, 1, -1}, {{0, 0}, {1, -half}, {0, 0}, {1, -half}}}, false},
      {{0, 0, 3},
       1,
       true,
       {{0, q("-0.25"), q("0.25")},
        {{q("1.25"), q("0.625")},
         {q("0.75"), q("0.375")},
         {q("1.25"), q("0.625")},
         {q("0.75"), q("0.375")}}},
       true},
      // As printed; 0.025 looks like 0.25, and both are right.
      {{0, 0, -3},
       1,
       true,
       {{0, q("0.025"), q("-0.25")},
        {{q("0.75"), q("-0.375")},
         {q("1.25"), q("-0.625")},
         {q("0.75"), q("-0.375")},
         {q("1.25"), q("-0.625")}}},
       true},
  };
  for (const TableRow& row : rows) expect_row(fig4_grasp(row.preload), row);
}

TEST(TableIII, MisprintedForcesAreNoEquilibrium) {
  const Rational half(1, 2);
  const Problem problem({fig4_grasp(0), {0, 0, 3}}, NormalLaw::kUnilateral);
  EXPECT_NE(find_violation(problem, {{0, -1, 1}, {{0, half}, {0, 0}, {0, half}, {0, 0}}}),
            std::nullopt);
}

TEST(TableIII, LastRowHoldsForEveryYUpToAQuarter) {
  const Problem problem({fig4_grasp(1), {0, 0, -3}}, NormalLaw::kUnilateral);
  const std::vector<ContactForce> forces = {{q("0.75"), q("-0.375")},
                                            {q("1.25"), q("-0.625")},
                                            {q("0.75"), q("-0.375")},
                                            {q("1.25"), q("-0.625")}};
  for (const char* y : {"-0.25", "-0.1", "0", "0.025", "0.25"}) {
    EXPECT_EQ(find_violation(problem, {{0, q(y), q("-0.25")}, forces}), std::nullopt) << y;
  }
  for (const char* y : {"-0.2500001", "0.2500001"}) {
    EXPECT_NE(find_violation(problem, {{0, q(y), q("-0.25")}, forces}), std::nullopt) << y;
  }
}

// Fig. 3: linear tangential springs would leave the friction cone here. Fig. 4 without preload:
// the friction cones alone would hold any w_y.
TEST(Figures, EarlierMethodsAreWrongHere) {
  EXPECT_EQ(judged_verdict({{fig1_grasp(0), {0, -1, 0}}, NormalLaw::kUnilateral}), "stable");
  for (const char* load : {"1e-18", "1", "1e9", "-1e-18", "-1", "-1e9"}) {
    EXPECT_EQ(judged_verdict({{fig4_grasp(0), {0, q(load), 0}}, NormalLaw::kUnilateral}),
              "unstable");
  }
}

struct Threshold {
  const char* load;
  const char* verdict;
};

TEST(Thresholds, Fig1Upwards) {
  for (const Threshold& t : {Threshold{"0", "stable"},
                             {"1e-18", "stable"},
                             {"0.999999999999999999", "stable"},
                             {"1", "stable"},
                             {"1.000000000000000001", "unstable"},
                             {"1e9", "unstable"}}) {
    EXPECT_EQ(test::judged_verdicts({fig1_grasp(1), {0, q(t.load), 0}}), t.verdict) << t.load;
  }
  EXPECT_EQ(test::judged_verdicts({fig1_grasp(0), {0, q("1e-18"), 0}}), "unstable");
}

}  // namespace
}  // namespace stickslip
