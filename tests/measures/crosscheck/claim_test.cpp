// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/claim.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/planar/nearby.hpp"
#include "paper_grasps.hpp"
#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::fig1_grasp;
using test::fig4_grasp;
using Condition = ResidualCondition;

Rational number(const char* text) {
  return parse_rational(text);
}

Question ask_about(Grasp grasp, const Wrench& wrench, NormalLaw law = NormalLaw::kUnilateral) {
  return {LoadedGrasp{std::move(grasp), wrench}, law};
}

Claim verdict(bool stable) {
  Claim claim;
  claim.stable = stable;
  return claim;
}

RationalRow row(const Twist& d) {
  return {d.x, d.y, d.r};
}

/// With forces by the contacts' own normals and tangents.
Claim solution(const Grasp& grasp, const std::optional<Twist>& twist,
               const std::optional<std::vector<ContactForce>>& forces) {
  Claim claim = verdict(true);
  if (twist) claim.twist = row(*twist);
  if (forces) {
    claim.forces.emplace();
    for (std::size_t i = 0; i < forces->size(); ++i) {
      const Vector2 f = force_vector(grasp.contacts()[i].normal, (*forces)[i]);
      claim.forces->push_back({f.x, f.y});
    }
  }
  return claim;
}

/// Of one on the contacts of Fig. 1.
Claim solution(const Twist& twist, const std::vector<ContactForce>& forces) {
  return solution(fig1_grasp(1), twist, forces);
}

std::optional<Rational> exactly(const std::optional<DistanceBounds>& distance) {
  if (!distance) return std::nullopt;
  EXPECT_EQ(distance->high, distance->low);
  return distance->low;
}

const Rational kHalf(1, 2);

// Table I as printed: (c_n, c_t) and d.
struct PaperRow {
  Wrench wrench;
  int preload;
  Claim claim;
};

std::vector<PaperRow> table_1() {
  const auto f = [](const Rational& a, const Rational& b) { return ContactForce{a, b}; };
  return {{{0, 0, 0}, 0, solution({0, 0, 0}, {f(0, 0), f(0, 0), f(0, 0)})},
          {{0, 0, 0}, 1, solution({0, 0, 0}, {f(1, -kHalf), f(1, 0), f(1, kHalf)})},
          {{0, -1, 0}, 0, solution({0, -1, 0}, {f(0, 0), f(1, 0), f(0, 0)})},
          {{0, -2, 0}, 0, solution({0, -2, 0}, {f(0, 0), f(2, 0), f(0, 0)})},
          {{0, 1, 0}, 0, verdict(false)},
          {{0, 1, 0}, 1, solution({0, 1, 0}, {f(1, -kHalf), f(0, 0), f(1, kHalf)})},
          {{0, number("1.1"), 0}, 1, verdict(false)}};
}

void expect_none(const ClaimResiduals& residuals) {
  EXPECT_EQ(residuals.balance, RationalRow(3));
  for (const auto& residual : {residuals.cone, residuals.normal_law, residuals.dissipation}) {
    ASSERT_TRUE(residual.has_value());
    EXPECT_EQ(residual->value, RootSum());
    EXPECT_FALSE(residual->contact.has_value());
  }
  EXPECT_THAT(residuals.missed(0, {}), ::testing::IsEmpty());
}

TEST(JudgeClaim, TableOneIsRightAsPrinted) {
  for (const PaperRow& row : table_1()) {
    const ClaimReport report =
        judge_claim(ask_about(fig1_grasp(row.preload), row.wrench), row.claim);
    EXPECT_EQ(report.claim_class, ClaimClass::kRight);
    EXPECT_FALSE(report.inaccurate);
    EXPECT_FALSE(report.distance.has_value());
    if (!row.claim.stable) continue;
    expect_none(report.residuals);
    ASSERT_TRUE(report.nearby.has_value());
    EXPECT_TRUE(report.nearby->from_claim);
    EXPECT_EQ(report.nearby->force_distance, Rational(0));
    EXPECT_EQ(report.nearby->twist_distance, Rational(0));
    EXPECT_EQ(report.nearby->same_slip, true);
    EXPECT_TRUE(report.nearby->same_contacts);
  }
}

ClaimResiduals residuals(const Grasp& grasp, const Wrench& wrench, NormalLaw law,
                         const std::optional<Twist>& twist,
                         const std::optional<std::vector<ContactForce>>& forces) {
  return residuals_of(box_of(LoadedGrasp{grasp, wrench}), law, solution(grasp, twist, forces));
}

// Each residual by hand, at the contact where it was made. Fig. 1, w = (0, 1, 0), P = 1.
TEST(Residuals, OfPerturbedSolutions) {
  const auto of = [](const std::vector<ContactForce>& forces) {
    return residuals(fig1_grasp(1), {0, 1, 0}, NormalLaw::kUnilateral, Twist{0, 1, 0}, forces);
  };
  const std::vector<ContactForce> forces{{1, -kHalf}, {0, 0}, {1, kHalf}};

  std::vector<ContactForce> changed = forces;
  changed[2].tangential = Rational(3, 4);  // by 1/4 outside the cone; slip there is -1
  ClaimResiduals r = of(changed);
  // t = (0, -1) at (1, 0): force (0, -1/4), torque -1/4.
  EXPECT_EQ(r.balance, (RationalRow{0, Rational(-1, 4), Rational(-1, 4)}));
  EXPECT_EQ(r.cone->value, RootSum(Rational(1, 4)));
  EXPECT_EQ(r.cone->contact, ContactId(2));
  EXPECT_EQ(r.normal_law->value, RootSum());
  EXPECT_EQ(r.dissipation->value, RootSum(Rational(1, 4)));
  EXPECT_EQ(r.dissipation->contact, ContactId(2));
  using ::testing::ElementsAre;
  EXPECT_THAT(r.missed(Rational(1, 4), {}), ElementsAre());
  EXPECT_THAT(r.missed(Rational(6, 25), {}),
              ElementsAre(Condition::kBalance, Condition::kCone, Condition::kDissipation));
  // Each is held against its own scale: forces, torques and powers.
  EXPECT_THAT(r.missed(Rational(1, 8), {2, 1, 1}), ElementsAre());
  EXPECT_THAT(r.missed(Rational(1, 8), {2, Rational(1, 2), 1}),
              ElementsAre(Condition::kBalance));
  EXPECT_THAT(r.missed(Rational(1, 8), {2, 1, Rational(1, 2)}),
              ElementsAre(Condition::kDissipation));

  changed = forces;
  changed[1].normal = Rational(-1, 3);  // pulls
  r = of(changed);
  EXPECT_EQ(r.balance, (RationalRow{0, Rational(-1, 3), 0}));
  EXPECT_EQ(r.cone->value, RootSum(Rational(1, 3)));  // -a; |b| - mu a is 1/6
  EXPECT_EQ(r.cone->contact, ContactId(1));
}

TEST(Residuals, NormalLawKnowsWhetherContactsOpen) {
  // d = (0, 2, 0): v = -1 at contact 1.
  const auto under = [](NormalLaw law) {
    return residuals(fig1_grasp(1), {0, 1, 0}, law, Twist{0, 2, 0},
                     {{{1, -kHalf}, {0, 0}, {1, kHalf}}});
  };
  EXPECT_EQ(under(NormalLaw::kUnilateral).normal_law->value, RootSum());
  const ClaimResiduals holds = under(NormalLaw::kBilateral);
  EXPECT_EQ(holds.normal_law->value, RootSum(1));
  EXPECT_EQ(holds.normal_law->contact, ContactId(1));
}

TEST(Residuals, WithoutTwistOrForcesWhatNeedsThemIsAbsent) {
  const auto of = [](const std::optional<Twist>& twist,
                     const std::optional<std::vector<ContactForce>>& forces) {
    return residuals(fig1_grasp(1), {0, 1, 0}, NormalLaw::kUnilateral, twist, forces);
  };
  const ClaimResiduals r = of(std::nullopt, std::vector<ContactForce>(3));
  EXPECT_TRUE(r.balance && r.cone && !r.normal_law && !r.dissipation);
  const ClaimResiduals none = of(Twist{}, std::nullopt);
  EXPECT_TRUE(!none.balance && !none.cone && !none.normal_law && !none.dissipation);
}

// Normals (3, 4) and (1, 1): coefficients times 5 and times sqrt(2) are forces.
TEST(Residuals, AreForcesWhateverTheLengthOfTheNormal) {
  const auto of = [](const Vector2& normal) {
    // In balance with 2 n + 3 t.
    const Wrench load{3 * normal.y - 2 * normal.x, -3 * normal.x - 2 * normal.y, 0};
    return residuals(Grasp({{{0, 0}, normal, kHalf, 1, 0}}), load, NormalLaw::kUnilateral,
                     Twist{}, {{{2, 3}}});
  };
  const ClaimResiduals rational = of({3, 4});
  EXPECT_EQ(rational.balance, RationalRow(3));
  EXPECT_EQ(rational.cone->value, RootSum(10));  // (3 - 1) * 5
  EXPECT_EQ(rational.normal_law->value, RootSum(10));
  const ClaimResiduals irrational = of({1, 1});
  EXPECT_EQ(irrational.cone->value, RootSum::root(2, 2));
  EXPECT_THAT(irrational.missed(Rational(283, 100), {}), ::testing::IsEmpty());  // 2 sqrt 2
  EXPECT_THAT(irrational.missed(Rational(282, 100), {}),
              ::testing::ElementsAre(Condition::kCone, Condition::kNormalLaw));
}

TEST(Residuals, ScaleIsThatOfTheForcesAndMotions) {
  const auto expect = [](const LoadedGrasp& loaded, const Claim& claim, const Rational& force,
                         const Rational& length, const Rational& motion) {
    const ResidualScale scale = residual_scale(box_of(loaded), claim);
    EXPECT_EQ(scale.force, force);
    EXPECT_EQ(scale.length, length);
    EXPECT_EQ(scale.motion, motion);
  };
  expect({Grasp(), {}}, {}, 1, 1, 1);
  expect({Grasp(), {0, -3, 2}}, {}, 3, 1, 3);
  // At (0, -4) with normal (3, 4), k = 5.
  const auto grasp = [](int preload) { return Grasp({{{0, -4}, {3, 4}, kHalf, 5, preload}}); };
  const auto claim = [&](const Twist& d) { return solution(grasp(7), d, {{{2, -1}}}); };
  expect({grasp(0), {}}, {}, 1, 4, Rational(1, 5));
  expect({grasp(0), {1, 0, -8}}, {}, 2, 4, Rational(2, 5));  // torque / 4
  expect({grasp(7), {1, 0, -8}}, {}, 7, 4, Rational(7, 5));
  // 2 (3, 4) - (-4, 3) = (10, 5)
  expect({grasp(7), {1, 0, -8}}, claim({0, -1, 0}), 10, 4, 2);
  expect({grasp(7), {1, 0, -8}}, claim({0, -1, 1}), 10, 4, 4);
  expect({grasp(7), {1, 0, -8}}, claim({0, -5, 1}), 10, 4, 5);
}

TEST(JudgeClaim, AMotionOfNoiseIsAccurate) {
  // Nothing moves, says a program in doubles, but for 1e-17.
  Claim claim =
      solution({number("1e-17"), number("-1e-17"), 0}, {{1, -kHalf}, {1, 0}, {1, kHalf}});
  EXPECT_FALSE(judge_claim(ask_about(fig1_grasp(1), {0, 0, 0}), claim).inaccurate);
}

TEST(JudgeClaim, ForcesBeyondTheToleranceAreReportedAndNotWrong) {
  const Question question = ask_about(fig1_grasp(1), {0, 1, 0});
  const auto claim = [](const char* change) {
    return solution({0, 1, 0}, {{1, -kHalf}, {0, 0}, {1, kHalf - number(change)}});
  };
  const ClaimReport near = judge_claim(question, claim("1e-6"));
  EXPECT_EQ(near.claim_class, ClaimClass::kRight);
  EXPECT_FALSE(near.inaccurate);
  const ClaimReport far = judge_claim(question, claim("1.1e-6"));
  EXPECT_EQ(far.claim_class, ClaimClass::kRight);
  EXPECT_TRUE(far.inaccurate);
  EXPECT_EQ(far.nearby->force_distance, number("1.1e-6"));
  EXPECT_TRUE(far.nearby->from_claim);
}

TEST(JudgeClaim, ThresholdWithPreloadIsATieWithinRounding) {
  struct Case {
    Grasp grasp;
    int threshold;
  };
  for (const auto& [grasp, threshold] : {Case{fig1_grasp(1), 1}, Case{fig4_grasp(1), 2}}) {
    for (const char* change : {"1e-12", "0", "-1e-12"}) {
      const Wrench load{0, threshold * (1 + number(change)), 0};
      const bool stable = number(change).sign() <= 0;
      const ClaimReport report = judge_claim(ask_about(grasp, load), verdict(!stable));
      EXPECT_EQ(report.claim_class, ClaimClass::kTie) << change;
      EXPECT_EQ(exactly(report.distance->along_load), abs(1 / (1 + number(change)) - 1))
          << change;
    }
    const ClaimReport wrong =
        judge_claim(ask_about(grasp, {0, threshold * number("1.0001"), 0}), verdict(true));
    EXPECT_EQ(wrong.claim_class, ClaimClass::kWrong);
    EXPECT_EQ(exactly(wrong.distance->along_load), Rational(1, 10001));
  }
}

TEST(JudgeClaim, TieDistanceIsTheCallersAndIncluded) {
  const Question question = ask_about(fig1_grasp(1), {0, number("1.25"), 0});
  ClaimOptions options;
  options.tie_distance = Rational(1, 5);  // 1 / 1.25 = 1 - 1/5
  EXPECT_EQ(judge_claim(question, verdict(true), options).claim_class, ClaimClass::kTie);
  options.tie_distance = number("0.199999999999999999");
  EXPECT_EQ(judge_claim(question, verdict(true), options).claim_class, ClaimClass::kWrong);
}

// Fig. 1 without preload resists exactly w_y <= 0 at zero torque: no multiple of (1, 1e-13, 0)
// but 0, and yet the load is within 1e-13 of a resisted one.
TEST(JudgeClaim, TieWithoutPreloadIsSeenAlongTheAxes) {
  for (const char* size : {"1", "1e9", "1e-9"}) {
    const Rational scale = number(size);
    const Wrench load{scale, number("1e-13") * scale, 0};
    const ClaimReport tie = judge_claim(ask_about(fig1_grasp(0), load), verdict(true));
    EXPECT_EQ(tie.claim_class, ClaimClass::kTie);
    EXPECT_EQ(exactly(tie.distance->along_load), Rational(1));
    EXPECT_EQ(exactly(tie.distance->along_axes), number("1e-13"));
    const Wrench changed = load + number("1e-13") * wrench_of(tie.distance->axis);
    EXPECT_EQ(judge_claim(ask_about(fig1_grasp(0), changed), verdict(true)).claim_class,
              ClaimClass::kRight);
    const ClaimReport wrong = judge_claim(
        ask_about(fig1_grasp(0), {scale, Rational(1, 4) * scale, 0}), verdict(true));
    EXPECT_EQ(wrong.claim_class, ClaimClass::kWrong);
    EXPECT_EQ(exactly(wrong.distance->along_axes), Rational(1, 4));
  }
}

TEST(JudgeClaim, NoContactAndNoLoad) {
  EXPECT_EQ(judge_claim(ask_about(Grasp(), {}), verdict(true)).claim_class, ClaimClass::kRight);
  // Any load at all would be too much: a tie.
  EXPECT_EQ(judge_claim(ask_about(Grasp(), {}), verdict(false)).claim_class, ClaimClass::kTie);
  const ClaimReport wrong = judge_claim(ask_about(Grasp(), {0, 1, 0}), verdict(true));
  EXPECT_EQ(wrong.claim_class, ClaimClass::kWrong);
  EXPECT_EQ(exactly(wrong.distance->smallest()), Rational(1));
  EXPECT_EQ(judge_claim(ask_about(Grasp(), {}), solution(Grasp(), Twist{}, {{}})).claim_class,
            ClaimClass::kRight);
}

TEST(JudgeClaim, RejectsForcesThatAreNotOnePerContact) {
  EXPECT_THROW(judge_claim(ask_about(fig1_grasp(1), {}), solution({}, {{1, 0}})), InputError);
}

TEST(JudgeClaim, ClaimedSlipIsExact) {
  Claim claim = verdict(true);
  claim.twist = RationalRow{0, number("1e-30"), 0};
  const ClaimReport report = judge_claim(ask_about(fig1_grasp(1), {0, 0, 0}), claim);
  EXPECT_EQ(report.claimed_slip,
            (std::vector<Sign>{Sign::kPositive, Sign::kZero, Sign::kNegative}));
}

/// A number of the size of rounding errors.
Rational noise(test::RandomSource& random) {
  return random.between(-1000, 1000) * number("1e-14");
}

// An exact equilibrium with noise is led back to an exact one nearby.
TEST(FindWitnessLike, UndoesNoise) {
  std::size_t found = 0;
  std::size_t asked = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    test::RandomSource random(seed);
    const NormalLaw law = random.one_in(2) ? NormalLaw::kUnilateral : NormalLaw::kBilateral;
    const std::size_t contacts = static_cast<std::size_t>(random.between(1, 7));
    const Grasp grasp = random.one_in(2) ? test::generic_grasp(random, contacts)
                                         : test::degenerate_grasp(random, contacts);
    const Problem problem({grasp, test::planted_wrench(random, grasp, law)}, law);
    const Decision decision = decide(problem);
    const auto* stable = std::get_if<Stable>(&decision.verdict);
    ASSERT_NE(stable, nullptr) << "planted loads are resisted, seed " << seed;
    ApproximateEquilibrium noisy{stable->witness().twist, stable->witness().forces};
    noisy.twist->x += noise(random);
    noisy.twist->y += noise(random);
    noisy.twist->r += noise(random);
    for (ContactForce& force : *noisy.forces) {
      force.normal += noise(random);
      force.tangential += noise(random);
    }
    ++asked;
    const auto witness = find_witness_like(problem, noisy);
    if (!witness) continue;
    ++found;
    EXPECT_EQ(find_violation(problem, *witness), std::nullopt) << "seed " << seed;
    // Forces follow from the motion with the condition of the system, which is small here.
    for (std::size_t i = 0; i < problem.size(); ++i) {
      EXPECT_LT(abs(witness->forces[i].normal - (*noisy.forces)[i].normal), number("1e-6"))
          << "seed " << seed;
    }
  }
  EXPECT_GE(10 * found, 9 * asked) << found << " of " << asked;
}

TEST(FindWitnessLike, ExactEquilibriaAreTheirOwn) {
  const Problem problem({fig4_grasp(1), {0, 0, -3}}, NormalLaw::kUnilateral);
  // The last row of Table III as printed: one of many motions that serve.
  const Twist d{0, number("0.025"), number("-0.25")};
  const std::vector<ContactForce> forces{{number("0.75"), number("-0.375")},
                                         {number("1.25"), number("-0.625")},
                                         {number("0.75"), number("-0.375")},
                                         {number("1.25"), number("-0.625")}};
  const auto witness = find_witness_like(problem, {d, forces});
  ASSERT_TRUE(witness.has_value());
  EXPECT_EQ(witness->twist, d);
  // From the motion alone: the free part of the motion stays.
  const auto by_twist = find_witness_like(problem, {d, std::nullopt});
  ASSERT_TRUE(by_twist.has_value());
  EXPECT_EQ(by_twist->twist, d);
  // From the forces alone.
  const auto by_forces = find_witness_like(problem, {std::nullopt, forces});
  ASSERT_TRUE(by_forces.has_value());
  EXPECT_EQ(by_forces->forces[1].tangential, number("-0.625"));
}

TEST(FindWitnessLike, NothingForLoadsThatAreNotResisted) {
  const Problem problem({fig1_grasp(1), {0, 2, 0}}, NormalLaw::kUnilateral);
  EXPECT_FALSE(find_witness_like(problem, {Twist{0, 1, 0}, std::nullopt}).has_value());
  EXPECT_THROW(find_witness_like(problem, {}), ContractError);
}

// The distance against verdicts beside it: nothing changes before, and all changes behind.
TEST(ThresholdDistance, IsWhereTheVerdictChanges) {
  std::size_t seen = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    test::RandomSource random(seed);
    const Grasp grasp = test::degenerate_grasp(random, 1 + seed % 4);
    const Wrench w = test::small_wrench(random);
    const Problem problem({grasp, w}, NormalLaw::kUnilateral);
    const auto stable_at = [&](const Wrench& load) {
      return std::holds_alternative<Stable>(
          decide(problem.with_wrench(load), by(Engine::kStates)).verdict);
    };
    const bool stable = stable_at(w);
    const ThresholdDistance distance = threshold_distance(problem, grasp);
    const Rational beside = number("1e-20");
    if (distance.along_load) {
      ++seen;
      const Rational s = *exactly(distance.along_load);
      for (const int side : {-1, 1}) {
        if (s > beside && (side > 0 || s < 1)) {
          EXPECT_EQ(stable_at((1 + side * (s - beside)) * w), stable) << seed;
        }
      }
      EXPECT_TRUE(stable_at((1 + s) * w) != stable || stable_at((1 - s) * w) != stable ||
                  stable_at((1 + s + beside) * w) != stable ||
                  (s <= 1 && stable_at((1 - s - beside) * w) != stable))
          << seed;
    }
    if (distance.along_axes) {
      ++seen;
      const Rational s = *exactly(distance.along_axes);
      const Wrench axis = wrench_of(distance.axis);
      if (s > beside) {
        EXPECT_EQ(stable_at(w + (s - beside) * axis), stable) << seed;
      }
      EXPECT_TRUE(stable_at(w + s * axis) != stable ||
                  stable_at(w + (s + beside) * axis) != stable)
          << seed;
    }
  }
  EXPECT_GT(seen, 50);
}

}  // namespace
}  // namespace stickslip
