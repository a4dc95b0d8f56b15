// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about grasps in space: closed forms on both sides of thresholds, residuals against
// formulas in doubles, and right claims that are changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "both_checkers.hpp"
#include "random_source.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/measures/claim.hpp"

namespace stickslip {
namespace {

using Condition = ResidualCondition;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Rational number(const char* text) {
  return parse_rational(text);
}

UncertainContact contact(const RationalRow& position, const RationalRow& normal,
                         const Rational& friction, const Rational& preload = 0,
                         const Rational& stiffness = 1) {
  UncertainContact c;
  for (const Rational& x : position) c.position.push_back(point_interval(x));
  c.normal = normal;
  c.friction = point_interval(friction);
  c.preload = point_interval(preload);
  c.stiffness = point_interval(stiffness);
  return c;
}

Question ask_about(std::vector<UncertainContact> contacts, const RationalRow& wrench,
                   NormalLaw law = NormalLaw::kUnilateral) {
  GraspBox box;
  box.contacts = std::move(contacts);
  for (const Rational& w : wrench) box.wrench.push_back(point_interval(w));
  return {box, law};
}

const Rational kHalf(1, 2);

/// Two fingers that press with 4: they hold a weight of 4.
Question pinch(const Rational& weight) {
  return ask_about(
      {contact({-1, 0, 0}, {1, 0, 0}, kHalf, 4), contact({1, 0, 0}, {-1, 0, 0}, kHalf, 4)},
      {0, 0, -weight, 0, 0, 0});
}

/// examples/grasps/space-cup.json: each finger can hold a weight of 1.
Question cup(const Rational& weight, NormalLaw law = NormalLaw::kUnilateral) {
  return ask_about({contact({-4, 0, 2}, {1, 0, 0}, kHalf, 2),
                    contact({number("12/5"), number("16/5"), 2}, {-3, -4, 0}, kHalf, 2),
                    contact({number("12/5"), number("-16/5"), 2}, {-3, 4, 0}, kHalf, 2)},
                   {0, 0, -weight, 0, 0, 0}, law);
}

/// Three feet on the floor under a weight of 3, in whose plane they are pushed.
Question feet(const Rational& push) {
  return ask_about({contact({2, 0, 0}, {0, 0, 1}, kHalf), contact({-1, 2, 0}, {0, 0, 1}, kHalf),
                    contact({-1, -2, 0}, {0, 0, 1}, kHalf)},
                   {push, 0, -3, 0, 0, 0});
}

Claim verdict(bool stable) {
  Claim claim;
  claim.stable = stable;
  return claim;
}

Claim solution(RationalRow twist, std::vector<RationalRow> forces) {
  return {true, std::move(twist), std::move(forces)};
}

/// The exact verdict's proof is accepted.
ClaimReport judge(const Question& question, const Claim& claim,
                  const ClaimOptions& options = {}) {
  ClaimReport report = judge_claim(question, claim, options);
  EXPECT_STREQ(report.answer.engine(), "space");
  if (is_stable(report.answer.verdict)) {
    QuestionOptions asked;
    asked.law = question.law;
    test::expect_accepted_by_both(
        test::input_of(write_grasp(question.grasp), asked,
                       BoxDecision{report.answer.verdict, {}, report.answer.bits}));
  }
  return report;
}

void expect_none(const ClaimResiduals& residuals) {
  EXPECT_EQ(residuals.balance, RationalRow(6));
  for (const auto& residual : {residuals.cone, residuals.normal_law, residuals.dissipation}) {
    ASSERT_TRUE(residual.has_value());
    EXPECT_TRUE(residual->value == RootSum());
    EXPECT_FALSE(residual->contact.has_value());
  }
  EXPECT_THAT(residuals.missed(0, {}), IsEmpty());
}

// Thresholds in closed form, from both sides.
TEST(SpaceClaims, BothSidesOfAThreshold) {
  struct Case {
    Question (*at)(const Rational&);
    Rational threshold;
  };
  for (const auto& [at, threshold] : {Case{pinch, 4}, Case{feet, number("3/2")}}) {
    for (const char* change : {"-1e-3", "1e-3"}) {
      const bool stable = number(change).sign() < 0;
      const Question question = at(threshold * (1 + number(change)));
      EXPECT_EQ(judge(question, verdict(stable)).claim_class, ClaimClass::kRight) << change;
    }
    const ClaimReport wrong = judge(at(threshold * number("1.001")), verdict(true));
    EXPECT_EQ(wrong.claim_class, ClaimClass::kWrong);
    ASSERT_TRUE(wrong.distance && wrong.distance->all_at_once);
    EXPECT_EQ(wrong.distance->all_at_once->low, number("1e-9"));
    EXPECT_EQ(wrong.distance->all_at_once->high, std::nullopt);
  }
  // Feet: held whatever the multiple, and so is what they do not hold, but for no load.
  const ClaimReport held = judge(feet(number("1.4")), verdict(false));
  EXPECT_EQ(held.claim_class, ClaimClass::kWrong);
  EXPECT_FALSE(held.distance->along_load.has_value());
  EXPECT_EQ(held.distance->smallest()->low, number("1e-9"));
  const ClaimReport slides = judge(feet(number("1.6")), verdict(true));
  EXPECT_EQ(slides.distance->along_load->low, 1);
  EXPECT_EQ(slides.distance->along_load->high, Rational(1));
}

// The pinch holds 4: the load is that many times as large.
TEST(SpaceClaims, TheDistanceAlongTheLoadIsEnclosed) {
  for (const char* weight : {"1", "3", "5", "8"}) {
    const Rational load = number(weight);
    const bool stable = load < 4;
    ClaimOptions options;
    options.all_distances = true;
    const ClaimReport report = judge(pinch(load), verdict(stable), options);
    EXPECT_EQ(report.claim_class, ClaimClass::kRight);
    ASSERT_TRUE(report.distance && report.distance->along_load);
    const auto& [low, high] = *report.distance->along_load;
    const Rational exact = abs(4 / load - 1);
    ASSERT_TRUE(high.has_value());
    EXPECT_LE(low, exact) << weight;
    EXPECT_GE(*high, exact) << weight;
    EXPECT_LT(*high - low, exact / 4) << weight;
  }
}

TEST(SpaceClaims, TiesAreWithinTheirDistance) {
  // At the threshold and next to it.
  for (const char* weight : {"4", "4.000000000001", "3.999999999999"}) {
    const bool stable = number(weight) <= 4;
    const ClaimReport report = judge(pinch(number(weight)), verdict(!stable));
    EXPECT_EQ(report.claim_class, ClaimClass::kTie) << weight;
    EXPECT_EQ(report.distance->all_at_once->high, number("1e-9")) << weight;
  }
  // The caller's: 5 is one fifth too much.
  ClaimOptions options;
  options.tie_distance = number("0.21");
  EXPECT_EQ(judge(pinch(5), verdict(true), options).claim_class, ClaimClass::kTie);
  options.tie_distance = number("1e-3");
  EXPECT_EQ(judge(pinch(5), verdict(true), options).claim_class, ClaimClass::kWrong);
  options.tie_distance = 0;
  EXPECT_EQ(judge(pinch(5), verdict(true), options).claim_class, ClaimClass::kWrong);
}

// Nothing keeps it from turning about the line through the fingers: any torque about it is too
// much, which no multiple of the weight sees.
TEST(SpaceClaims, TiesAreSeenBesideTheLoad) {
  const ClaimReport tie = judge(pinch(2), verdict(false));
  EXPECT_EQ(tie.claim_class, ClaimClass::kTie);
  EXPECT_GE(tie.distance->along_load->low, 1);
  // Fingers around a cup hold torques as well.
  EXPECT_EQ(judge(cup(2), verdict(false)).claim_class, ClaimClass::kWrong);
}

TEST(SpaceClaims, NoContactAndNoLoad) {
  EXPECT_EQ(judge(ask_about({}, RationalRow(6)), verdict(true)).claim_class,
            ClaimClass::kRight);
  EXPECT_EQ(judge(ask_about({}, RationalRow(6)), verdict(false)).claim_class, ClaimClass::kTie);
  EXPECT_EQ(judge(ask_about({}, {0, 0, 1, 0, 0, 0}), verdict(true)).claim_class,
            ClaimClass::kWrong);
  EXPECT_EQ(judge(ask_about({}, RationalRow(6)), solution(RationalRow(6), {})).claim_class,
            ClaimClass::kRight);
}

TEST(SpaceClaims, UndecidedSaysWhy) {
  ClaimOptions options;
  options.node_limit = 1;
  const ClaimReport report = judge(cup(8), verdict(true), options);
  EXPECT_EQ(report.claim_class, ClaimClass::kUndecided);
  EXPECT_FALSE(report.distance.has_value());
  const auto* undecided = std::get_if<Undecided>(&report.answer.verdict);
  ASSERT_NE(undecided, nullptr);
  EXPECT_EQ(undecided->reason, "nodes");
}

// A contact that slips along (3, 4) under all that its friction can bear.
TEST(SpaceClaims, AnEquilibriumThatSlips) {
  const Question question =
      ask_about({contact({0, 0, 0}, {0, 0, 2}, kHalf)}, {3, 4, -10, 0, 0, 0});
  const Claim claim = solution({6, 8, -10, 0, 0, 0}, {{-3, -4, 10}});
  const ClaimReport report = judge(question, claim);
  EXPECT_EQ(report.claim_class, ClaimClass::kRight);
  expect_none(report.residuals);
  ASSERT_TRUE(report.nearby.has_value());
  EXPECT_TRUE(report.nearby->from_claim);
  EXPECT_EQ(report.nearby->force_distance, Rational(0));
  EXPECT_EQ(report.claimed_slip, (std::vector<Sign>{Sign::kPositive}));
  // Across the slip by 1, and in the cone still.
  Claim turned = claim;
  turned.forces = {{{-4, -3, 10}}};
  const ClaimReport changed = judge(question, turned);
  EXPECT_TRUE(changed.residuals.cone->value == RootSum());
  // mu f_n |s| = 50, and f_t.s = -48.
  EXPECT_TRUE(changed.residuals.dissipation->value == RootSum(2));
  EXPECT_EQ(changed.residuals.balance, (RationalRow{-1, 1, 0, 0, 0, 0}));
}

// One contact slips and the other, along whose normal it moves, sticks with friction. With so
// few nodes the engine knows nothing of it, and the claim is the proof.
TEST(SpaceClaims, AnEquilibriumProvesItself) {
  // At the end of all friction: the contacts share the force along the line between them in one
  // way alone, along (28, 45, 0) over 53, which doubles miss.
  const Rational a = number("10/7");
  const Question question = ask_about(
      {contact({0, 0, 0}, {0, 0, 1}, kHalf, a), contact({1, 0, 0}, {0, 0, 1}, kHalf, a)},
      {number("-40/53"), number("-450/371"), -2 * a, 0, a, number("-225/371")});
  const RationalRow force{number("20/53"), number("225/371"), a};
  const Claim claim = solution(RationalRow(6), {force, force});
  ClaimOptions options;
  options.node_limit = 1;
  EXPECT_EQ(judge(question, verdict(true), options).claim_class, ClaimClass::kUndecided);
  const ClaimReport report = judge(question, claim, options);
  EXPECT_EQ(report.claim_class, ClaimClass::kRight);
  expect_none(report.residuals);
  const auto* stable = std::get_if<Stable>(&report.answer.verdict);
  ASSERT_NE(stable, nullptr);
  EXPECT_EQ(std::get<ShareWitness>(stable->proof).shares.size(), 2U);
  // Next to it, it proves nothing.
  Claim off = claim;
  (*off.forces)[1][2] += number("1e-30");
  EXPECT_EQ(judge(question, off, options).claim_class, ClaimClass::kUndecided);
}

// Lengths that are irrational, by hand.
TEST(SpaceResiduals, AreRoots) {
  // Upright: f = (1, 1, 1), |f_t| = sqrt 2.
  const Question upright =
      ask_about({contact({0, 0, 0}, {0, 0, 1}, kHalf, 1)}, {-1, -1, -1, 0, 0, 0});
  const auto of = [](const Question& question, const Claim& claim) {
    return residuals_of(*question.box(), question.law, claim);
  };
  ClaimResiduals r = of(upright, solution({1, 0, 0, 0, 0, 0}, {{1, 1, 1}}));
  EXPECT_EQ(r.balance, RationalRow(6));
  EXPECT_TRUE(r.cone->value == RootSum::root(1, 2) - RootSum(kHalf));
  EXPECT_TRUE(r.normal_law->value == RootSum());
  EXPECT_TRUE(r.dissipation->value == RootSum(number("3/2")));  // 1/2 + 1
  // sqrt 2 - 1/2 = 0.91421356237309504880...
  EXPECT_THAT(r.missed(number("0.91421356237309504880"), {1, 1, 2}),
              ElementsAre(Condition::kCone));
  EXPECT_THAT(r.missed(number("0.91421356237309504881"), {1, 1, 2}), IsEmpty());
  // Along (1, 1, 1): f_n = 2 sqrt 3, and P - k n.u = 1 - sqrt 3 is open.
  const Question diagonal =
      ask_about({contact({0, 0, 0}, {1, 1, 1}, kHalf, 1)}, {-2, -2, -2, 0, 0, 0});
  r = of(diagonal, solution({1, 1, 1, 0, 0, 0}, {{2, 2, 2}}));
  EXPECT_TRUE(r.normal_law->value == RootSum::root(2, 3));
  Question bilateral = diagonal;
  bilateral.law = NormalLaw::kBilateral;
  r = of(bilateral, solution({1, 1, 1, 0, 0, 0}, {{2, 2, 2}}));
  EXPECT_TRUE(r.normal_law->value == RootSum::root(3, 3) - RootSum(1));
  // And pressed: 1 + sqrt 3.
  r = of(diagonal, solution({-1, -1, -1, 0, 0, 0}, {{2, 2, 2}}));
  EXPECT_TRUE(r.normal_law->value == RootSum::root(1, 3) - RootSum(1));
}

using Real3 = std::array<double, 3>;

Real3 reals(const RationalRow& row, std::size_t first = 0) {
  return {to_double(row[first]), to_double(row[first + 1]), to_double(row[first + 2])};
}
double product(const Real3& a, const Real3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Real3 cross_product(const Real3& a, const Real3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real3 without(const Real3& a, double factor, const Real3& b) {
  return {a[0] - factor * b[0], a[1] - factor * b[1], a[2] - factor * b[2]};
}

// The same from the definitions with unit normals, in doubles.
TEST(SpaceResiduals, AgainstDoubles) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    bench::RandomSource random(seed);
    const auto row = [&](std::size_t n, int most) {
      RationalRow result;
      for (std::size_t j = 0; j < n; ++j) {
        result.push_back(Rational(random.between(-most, most)) / random.between(1, 5));
      }
      return result;
    };
    std::vector<UncertainContact> contacts;
    Claim claim = solution(row(6, 3), {});
    for (int i = 0; i < 4; ++i) {
      RationalRow n = row(3, 4);
      if (n == RationalRow(3)) n[2] = 1;
      contacts.push_back(contact(row(3, 5), n, Rational(random.between(0, 8)) / 5,
                                 random.between(0, 4), Rational(random.between(1, 9)) / 2));
      claim.forces->push_back(row(3, 6));
    }
    const NormalLaw law = random.one_in(2) ? NormalLaw::kUnilateral : NormalLaw::kBilateral;
    const Question question = ask_about(contacts, row(6, 5), law);
    const ClaimResiduals found = residuals_of(*question.box(), law, claim);
    double cone = 0;
    double normal_law = 0;
    double dissipation = 0;
    Real3 force = reals({question.box()->wrench[0].low, question.box()->wrench[1].low,
                         question.box()->wrench[2].low});
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      Real3 n = reals(contacts[i].normal);
      const double length = std::sqrt(product(n, n));
      for (double& entry : n) entry /= length;
      const Real3 p = reals({contacts[i].position[0].low, contacts[i].position[1].low,
                             contacts[i].position[2].low});
      const Real3 f = reals((*claim.forces)[i]);
      force = without(force, -1, f);
      const Real3 moved =
          without(reals(*claim.twist), -1, cross_product(reals(*claim.twist, 3), p));
      const double pressed = product(f, n);
      const Real3 friction = without(f, pressed, n);
      const Real3 slip = without(moved, product(moved, n), n);
      const double mu = to_double(contacts[i].friction.low);
      cone = std::max({cone, std::sqrt(product(friction, friction)) - mu * pressed, -pressed});
      double spring = to_double(contacts[i].preload.low) -
                      to_double(contacts[i].stiffness.low) * product(n, moved);
      if (law == NormalLaw::kUnilateral) spring = std::max(spring, 0.0);
      normal_law = std::max(normal_law, std::fabs(pressed - spring));
      dissipation = std::max(
          dissipation,
          std::fabs(mu * pressed * std::sqrt(product(slip, slip)) + product(friction, slip)));
    }
    const auto value = [](const LargestResidual& r) {
      return to_double(r.value.between(100).first);
    };
    EXPECT_NEAR(value(*found.cone), cone, 1e-11) << seed;
    EXPECT_NEAR(value(*found.normal_law), normal_law, 1e-11) << seed;
    EXPECT_NEAR(value(*found.dissipation), dissipation, 1e-10) << seed;
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(to_double((*found.balance)[j]), force[j], 1e-11) << seed;
    }
    // What is missed is decided at the value itself.
    const RootSum& exact = found.cone->value;
    const auto [below, above] = exact.between(200);
    const auto misses = [&](const Rational& tolerance) {
      ClaimResiduals one;
      one.cone = found.cone;
      return !one.missed(tolerance, {}).empty();
    };
    if (const auto rational = exact.rational()) {
      EXPECT_FALSE(misses(*rational)) << seed;
    } else {
      EXPECT_TRUE(misses(below)) << seed;
      EXPECT_FALSE(misses(above)) << seed;
    }
  }
}

/// The same in the plane by its rows N and T and coefficients a and b, squared as forces are: a
/// naive twin of another form, exact.
struct PlanarResiduals {
  Wrench balance;
  Rational cone_squared = 0;
  Rational normal_law_squared = 0;
  Rational dissipation = 0;
};

PlanarResiduals by_rows(const Problem& problem, const Twist& d,
                        const std::vector<ContactForce>& forces) {
  PlanarResiduals result{problem.wrench()};
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const auto& [a, b] = forces[i];
    const Rational square = row.normal.x * row.normal.x + row.normal.y * row.normal.y;
    result.balance += a * row.normal + b * row.tangent;
    const Rational outside = std::max<Rational>({0, abs(b) - row.friction * a, -a});
    result.cone_squared = std::max(result.cone_squared, Rational(outside * outside * square));
    Rational v = row.normal_coefficient(d);
    if (problem.law() == NormalLaw::kUnilateral && v.sign() < 0) v = 0;
    result.normal_law_squared =
        std::max(result.normal_law_squared, Rational((a - v) * (a - v) * square));
    const Rational slip = power(row.tangent, d);
    result.dissipation =
        std::max<Rational>(result.dissipation, abs(row.friction * a * abs(slip) + b * slip));
  }
  return result;
}

// A grasp in the plane, and the same in space: the residuals of the plane, exactly.
TEST(SpaceResiduals, OfAGraspInThePlaneAreThoseOfThePlane) {
  const Vector2 normals[] = {{1, 0}, {-3, 4}, {5, -12}, {1, 1}, {-2, 1}};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    bench::RandomSource random(seed);
    const auto any = [&] { return Rational(random.between(-20, 20)) / random.between(1, 6); };
    std::vector<Contact> contacts;
    std::vector<ContactForce> forces;
    std::vector<UncertainContact> lifted;
    Claim planar = verdict(true);
    Claim spatial = verdict(true);
    const Twist d{any(), any(), any()};
    planar.twist = {d.x, d.y, d.r};
    spatial.twist = {d.x, d.y, 0, 0, 0, d.r};
    planar.forces.emplace();
    spatial.forces.emplace();
    for (int i = 0; i < 3; ++i) {
      const Vector2& n = normals[random.between(0, 4)];
      // Preloads with normals of rational length alone, as problems have them.
      const bool is_rational = exact_sqrt(n.x * n.x + n.y * n.y).has_value();
      contacts.push_back({{any(), any()},
                          n,
                          abs(any()),
                          1 + abs(any()),
                          is_rational ? Rational(abs(any())) : Rational(0)});
      const Contact& c = contacts.back();
      forces.push_back({any(), any()});
      const Vector2 f = force_vector(n, forces.back());
      planar.forces->push_back({f.x, f.y});
      spatial.forces->push_back({f.x, f.y, 0});
      lifted.push_back(contact({c.position.x, c.position.y, 0}, {n.x, n.y, 0}, c.friction,
                               c.preload, c.stiffness));
    }
    const NormalLaw law = random.one_in(2) ? NormalLaw::kUnilateral : NormalLaw::kBilateral;
    const Wrench w{any(), any(), any()};
    const LoadedGrasp loaded{Grasp(contacts), w};
    const ClaimResiduals in_plane = residuals_of(box_of(loaded), law, planar);
    const ClaimResiduals in_space =
        residuals_of(*ask_about(lifted, {w.x, w.y, 0, 0, 0, w.torque}).box(), law, spatial);
    const PlanarResiduals expected = by_rows(Problem(loaded, law), d, forces);
    EXPECT_EQ(in_plane.balance, row_of(expected.balance)) << seed;
    EXPECT_EQ(in_space.balance, (RationalRow{expected.balance.x, expected.balance.y, 0, 0, 0,
                                             expected.balance.torque}));
    for (const ClaimResiduals& found : {in_plane, in_space}) {
      EXPECT_EQ(found.cone->value.rational_square(), expected.cone_squared) << seed;
      EXPECT_EQ(found.normal_law->value.rational_square(), expected.normal_law_squared) << seed;
      EXPECT_EQ(found.dissipation->value.rational(), expected.dissipation) << seed;
    }
    EXPECT_EQ(in_plane.cone->contact, in_space.cone->contact);
  }
}

TEST(SpaceResiduals, ScaleIsThatOfTheForcesAndMotions) {
  const Question question =
      ask_about({contact({0, -4, 2}, {3, 4, 0}, kHalf, 1, 5)}, {1, 0, 0, 0, 8, -12});
  const auto expect = [&](const Claim& claim, const Rational& force, const Rational& motion) {
    const ResidualScale scale = residual_scale(*question.box(), claim);
    EXPECT_EQ(scale.force, force);
    EXPECT_EQ(scale.length, 4);
    EXPECT_EQ(scale.motion, motion);
  };
  expect({}, 3, number("3/5"));
  expect(solution({0, 0, -2, 0, 0, 0}, {{0, 0, -7}}), 7, 2);
  expect(solution({0, 0, -2, 0, -1, 0}, {{0, 0, -7}}), 7, 4);
}

// Each number of a right claim, changed: what is missed is missed, and the verdict stays.
TEST(SpaceClaims, ChangedSolutionsAreInaccurateAndNotWrong) {
  const Question question = cup(2);
  const ClaimReport exact = judge(question, verdict(true));
  const auto* stable = std::get_if<Stable>(&exact.answer.verdict);
  ASSERT_NE(stable, nullptr);
  const auto& witness = std::get<ShareWitness>(stable->proof);
  Claim right = verdict(true);
  right.twist = RationalRow(witness.twist.begin(), witness.twist.end());
  right.forces.emplace();
  for (const SpatialForce& f : forces_of(*question.box(), witness.twist, witness.shares)) {
    right.forces->emplace_back(f.force.begin(), f.force.end());
  }
  const ClaimReport accurate = judge(question, right);
  expect_none(accurate.residuals);
  EXPECT_FALSE(accurate.inaccurate);
  EXPECT_TRUE(accurate.nearby->from_claim);

  for (const char* change : {"1e-12", "1e-3"}) {
    const bool is_far = number(change) > number("1e-6");
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        Claim claim = right;
        (*claim.forces)[i][j] += number(change);
        const ClaimReport report = judge_claim(question, claim);
        EXPECT_EQ(report.claim_class, ClaimClass::kRight);
        EXPECT_EQ(report.inaccurate, is_far);
        EXPECT_EQ((*report.residuals.balance)[j], number(change));
        ASSERT_TRUE(report.nearby && report.nearby->force_distance);
        EXPECT_GT(*report.nearby->force_distance, 0);
        EXPECT_LE(*report.nearby->force_distance, 10 * number(change)) << i << j;
      }
    }
    for (std::size_t j = 0; j < 6; ++j) {
      Claim claim = right;
      (*claim.twist)[j] += number(change);
      const ClaimReport report = judge_claim(question, claim);
      EXPECT_EQ(report.inaccurate, is_far) << j;
      EXPECT_EQ(report.nearby->twist_distance, number(change)) << j;
    }
  }
}

// Where the equilibrium is proved and not stated there is none to compare with.
TEST(SpaceClaims, ProofsByDegreeHaveNoEquilibriumNearby) {
  // examples/grasps/space-corner.json
  const Rational mu = number("3/10");
  const Question question =
      ask_about({contact({-1, -1, -1}, {0, 0, 1}, mu), contact({1, -1, -1}, {0, 0, 1}, mu),
                 contact({0, 1, -1}, {0, 0, 1}, mu), contact({-1, 0, 0}, {1, 0, 0}, mu),
                 contact({0, -1, 0}, {0, 1, 0}, mu)},
                {-4, -1, -10, kHalf, -2, -1});
  const Claim claim = solution(RationalRow(6), std::vector<RationalRow>(5, RationalRow(3)));
  const ClaimReport report = judge(question, claim);
  EXPECT_EQ(report.claim_class, ClaimClass::kRight);
  EXPECT_TRUE(report.inaccurate);
  EXPECT_FALSE(report.nearby.has_value());
  EXPECT_TRUE(report.no_nearby.has_value());
}

TEST(SpaceClaims, RefusesWhatDoesNotFit) {
  EXPECT_THROW(judge_claim(cup(2), solution(RationalRow(6), {{1, 0, 0}})), InputError);
  EXPECT_THROW(judge_claim(cup(2), solution(RationalRow(3), {})), ContractError);
  Question uncertain = cup(2);
  uncertain.grasp.box()->contacts[0].friction = {number("0.4"), kHalf};
  EXPECT_THROW(judge_claim(uncertain, verdict(true)), InputError);
}

}  // namespace
}  // namespace stickslip
