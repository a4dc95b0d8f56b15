// SPDX-License-Identifier: GPL-3.0-or-later
// Witnesses state few shares of friction: against exact linear programs on small worlds, and
// where the least number is known.
#include "engine/planar/few_shares.hpp"

#include <gtest/gtest.h>

#include <iostream>

#include "both_checkers.hpp"
#include "family.hpp"
#include "judged.hpp"
#include "shares.hpp"
#include "stickslip/lp/linear_program.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip {

namespace {

using test::RandomSource;
using test::ShareCount;
using test::shares_of;

const Rational kHalf(1, 2);

Problem problem_of(std::vector<Contact> contacts, const Wrench& wrench,
                   NormalLaw law = NormalLaw::kUnilateral) {
  return Problem({Grasp(std::move(contacts)), wrench}, law);
}

/// The least sum of |shares| at rest, by an exact linear program; nothing if there is none.
std::optional<Rational> least_shares_at_rest(const Problem& problem) {
  LinearProgram program;
  const std::size_t m = problem.size();
  program.add_variables(2 * m, VariableKind::kNonNegative);  // b = mu a (plus - minus)
  for (std::size_t j = 0; j < 3; ++j) {
    std::vector<Rational> coefficients;
    Rational rest = -coordinates(problem.wrench())[j];
    for (const ContactRow& row : problem.rows()) {
      const Rational edge = row.friction * row.preload * coordinates(row.tangent)[j];
      coefficients.insert(coefficients.end(), {edge, -edge});
      rest -= row.preload * coordinates(row.normal)[j];
    }
    program.add_row(std::move(coefficients), Relation::kEqual, rest);
  }
  for (std::size_t i = 0; i < 2 * m; ++i) {
    std::vector<Rational> bound(i + 1);
    bound[i] = 1;
    program.add_row(std::move(bound), Relation::kLessEqual, 1);
  }
  program.minimize(std::vector<Rational>(2 * m, 1));
  const LpResult result = solve(program);
  if (std::holds_alternative<Infeasible>(result)) return std::nullopt;
  return std::get<Optimal>(result).value;
}

/// Costs of shares differ by a thousandth, so that the least sum may be missed by as much.
void expect_least(const Problem& problem, std::size_t& held) {
  const std::optional<Rational> least = least_shares_at_rest(problem);
  const std::optional<Witness> found = find_forces(problem, {});
  ASSERT_EQ(found.has_value(), least.has_value());
  if (!found) return;
  ++held;
  EXPECT_EQ(find_violation(problem, *found), std::nullopt);
  const ShareCount shares = shares_of(problem, *found);
  EXPECT_LE(shares.fractional, 3u);
  EXPECT_GE(shares.sum, *least);
  EXPECT_LE(shares.sum, *least * Rational(1001, 1000));
}

// Three contacts on the corners and the middle of a square, normals along the axes, and all
// loads that leave a wrench in {-1, 0, 1}^3 to friction: rank 1, 2 and 3, coincident contacts,
// no friction, thresholds.
TEST(FewShares, SmallWorldsAgainstExactPrograms) {
  std::vector<Contact> contacts;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {0, 0}, {1, 1}}) {
    for (const auto& [nx, ny] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      contacts.push_back({{x, y}, {nx, ny}, kHalf, 1, 1});
    }
  }
  std::size_t held = 0;
  std::size_t grasps = 0;
  for (std::size_t a = 0; a < contacts.size(); ++a) {
    for (std::size_t b = a; b < contacts.size(); ++b) {
      for (std::size_t c = b; c < contacts.size(); ++c, ++grasps) {
        std::vector<Contact> three{contacts[a], contacts[b], contacts[c]};
        three[0].friction = Rational(static_cast<int>(grasps % 5), 2);  // 0 to 2
        const Problem problem = problem_of(three, {});
        for (int w = 0; w < 27; ++w) {
          Wrench wrench{w % 3 - 1, w / 3 % 3 - 1, w / 9 - 1};
          for (const ContactRow& row : problem.rows()) wrench += Rational(-1) * row.normal;
          expect_least(problem_of(three, wrench), held);
        }
      }
    }
  }
  std::cout << 27 * grasps << " loads, " << held << " held at rest\n";
  EXPECT_EQ(grasps, 816u);
  EXPECT_GT(held, 3 * grasps);
  EXPECT_LT(held, 20 * grasps);
}

// Loads that rest holds, to the limit of friction and just beside it.
TEST(FewShares, RandomGraspsAgainstExactPrograms) {
  RandomSource random(4001);
  std::size_t at_limit = 0;
  std::size_t beside_it = 0;
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    const auto m = static_cast<std::size_t>(random.between(1, 9));
    const Grasp grasp = random.one_in(2)
                            ? test::generic_grasp(random, m)
                            : test::degenerate_grasp(random, m).with_preload(kHalf);
    const bool beside = random.one_in(2);
    const Wrench wrench =
        test::threshold_wrench(random, grasp, beside ? parse_rational("1e-12") : Rational(0));
    std::size_t now = 0;
    expect_least(Problem({grasp, wrench}, NormalLaw::kUnilateral), now);
    (beside ? beside_it : at_limit) += now;
  }
  std::cout << at_limit << " loads at the limit and " << beside_it << " beside it are held\n";
  EXPECT_GT(at_limit, 100u);
  EXPECT_GT(beside_it, 10u);  // less friction is left there
  EXPECT_LT(beside_it, 100u);
}

/// Pairs of contacts that face each other, preload 1, friction 1/2.
std::vector<Contact> facing_pairs(int pairs) {
  std::vector<Contact> contacts;
  for (int i = 0; i < pairs; ++i) {
    contacts.push_back({{-1, i}, {1, 0}, kHalf, 1, 1});
    contacts.push_back({{1, i}, {-1, 0}, kHalf, 1, 1});
  }
  return contacts;
}

/// Judged, and both checkers' answers asked for.
ShareCount judged_shares(const LoadedGrasp& loaded) {
  EXPECT_EQ(test::judged_verdict({loaded, NormalLaw::kUnilateral}), "stable");
  const Problem problem(loaded, NormalLaw::kUnilateral);
  return shares_of(problem, std::get<Stable>(branch_and_bound(problem)).witness());
}

TEST(FewShares, NoMoreContactsThanTheLoadNeeds) {
  const Grasp grasp(facing_pairs(20));
  for (const int halves : {0, 1, 2, 9, 39}) {
    // Each contact can hold 1/2; the pull needs half of one more. Two may balance its torque.
    const LoadedGrasp loaded{grasp, {0, Rational(2 * halves + 1, 4), 0}};
    const Problem problem(loaded, NormalLaw::kUnilateral);
    const Verdict verdict = branch_and_bound(problem);
    test::expect_accepted_by_both(loaded, NormalLaw::kUnilateral, verdict);
    const ShareCount shares = shares_of(problem, std::get<Stable>(verdict).witness());
    EXPECT_EQ(shares.sum, Rational(2 * halves + 1, 2)) << halves;
    EXPECT_LE(shares.nonzero, static_cast<std::size_t>(halves + 3)) << halves;
    EXPECT_LE(shares.fractional, 3u) << halves;
  }
}

TEST(FewShares, NoneWithoutFrictionOrLoad) {
  // Four pairs, at rest under no load; pressed on without friction; and no contact at all.
  EXPECT_EQ(judged_shares({Grasp(facing_pairs(4)), {}}).nonzero, 0u);
  std::vector<Contact> smooth = facing_pairs(3);
  for (Contact& contact : smooth) contact.friction = 0;
  EXPECT_EQ(judged_shares({Grasp(smooth), {1, 0, 0}}).nonzero, 0u);
  EXPECT_EQ(judged_shares({Grasp(), {}}).nonzero, 0u);
}

TEST(FewShares, NoneWhereAllSlip) {
  RandomSource random(4002);
  int none = 0;
  for (int round = 0; round < 30; ++round) {
    const Grasp grasp = test::generic_grasp(random, 5);
    const Problem without_load({grasp, {}}, NormalLaw::kUnilateral);
    // Any motion on which nothing sticks, and the load that its forces hold.
    const Twist d{Rational(round + 1, 7), Rational(3, 11), Rational(1, 5)};
    Wrench load;
    bool all_slip = true;
    for (const ContactRow& row : without_load.rows()) {
      const int slip = power(row.tangent, d).sign();
      const Rational a = std::max(Rational(0), row.normal_coefficient(d));
      all_slip = all_slip && slip != 0;
      load += -a * row.normal + (Rational(slip) * row.friction * a) * row.tangent;
    }
    if (!all_slip) continue;
    const Problem problem({grasp, load}, NormalLaw::kUnilateral);
    const std::optional<Witness> found = find_forces(problem, d);
    ASSERT_TRUE(found);
    EXPECT_EQ(find_violation(problem, *found), std::nullopt);
    EXPECT_EQ(shares_of(problem, *found).nonzero, 0u);
    // What slips has no say: a load a little off is not held.
    EXPECT_FALSE(find_forces(
        Problem({grasp, load + Wrench{0, parse_rational("1e-30"), 0}}, NormalLaw::kUnilateral),
        d));
    ++none;
  }
  EXPECT_GT(none, 20);
}

TEST(FewShares, BilateralMotionsThatPullAreRefused) {
  const Grasp grasp(facing_pairs(1));
  EXPECT_FALSE(find_forces(Problem({grasp, {}}, NormalLaw::kBilateral), {2, 0, 0}));
  EXPECT_TRUE(find_forces(Problem({grasp, {2, 0, 0}}, NormalLaw::kBilateral), {1, 0, 0}));
  EXPECT_FALSE(find_forces(Problem({grasp, {3, 0, 0}}, NormalLaw::kBilateral), {1, 0, 0}));
}

std::ptrdiff_t fractional(const ShortWitness& witness) {
  return std::count_if(witness.shares.begin(), witness.shares.end(),
                       [](const auto& share) { return abs(share.second) != 1; });
}

void expect_joined(const Question& question) {
  const auto result = find_margin(problem_of(question));
  const Margin& margin = std::get<Margin>(result);
  test::expect_accepted_by_both(question, margin);
  EXPECT_GT(margin.segments.size(), 5u);
  std::size_t joints = 0;
  for (std::size_t k = 0; k < margin.segments.size(); ++k) {
    const MarginSegment& segment = margin.segments[k];
    EXPECT_LE(fractional(segment.start), 3) << k;
    EXPECT_LE(fractional(segment.end), 3) << k;
    if (k == 0) continue;
    const MarginSegment& before = margin.segments[k - 1];
    if (before.high != segment.low) continue;
    ++joints;
    EXPECT_EQ(before.end, segment.start) << k;
  }
  EXPECT_GT(joints, 4u);
}

// Beyond rest nearly all contacts slip, and each that turns round sticks for a while.
TEST(FewShares, SegmentsOfAMarginMeetInOnePoint) {
  std::vector<Contact> contacts = facing_pairs(8);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    contacts[i].position.x *= 1 + Rational(static_cast<int>(i * i % 7), 5);
    contacts[i].preload = Rational(static_cast<int>(i % 3) + 1, 2);
  }
  contacts.push_back({{0, -2}, {0, 1}, kHalf, 1, 1});
  contacts.push_back({{0, 9}, {0, -1}, kHalf, 1, 1});
  const Wrench pull{Rational(1, 8), 1, Rational(1, 3)};
  expect_joined(test::margin_question({Grasp(contacts), {}}, NormalLaw::kUnilateral, pull));
  expect_joined(test::margin_question({Grasp(contacts), Rational(6) * pull},
                                      NormalLaw::kUnilateral, std::nullopt,
                                      PreloadDirection{true, {}}));
}

}  // namespace
}  // namespace stickslip
