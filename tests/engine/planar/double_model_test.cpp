// SPDX-License-Identifier: GPL-3.0-or-later
// A problem in doubles and its contacts in groups, against rationals; smooth balance against
// its formula and against differences; equilibria completed from their modes; and the forces of
// crowds against the exact rule of leaves.
#include "engine/planar/double_model.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/planar/crowd_forces.hpp"
#include "engine/planar/smooth_balance.hpp"
#include "engine/planar/witness_search.hpp"
#include "random_grasps.hpp"

namespace stickslip {
namespace double_model_test {

using test::RandomSource;

Problem random_problem(RandomSource& random, int most) {
  const auto m = static_cast<std::size_t>(random.between(1, most));
  const Grasp grasp =
      random.one_in(2) ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
  return Problem(LoadedGrasp{grasp, test::small_wrench(random)}, NormalLaw::kUnilateral);
}

/// A point with entries of at most 1, exactly and in doubles.
struct Point {
  Vector5 exact;
  Double5 rounded;
};

Point random_point(RandomSource& random) {
  Point x;
  for (std::size_t j = 0; j < 5; ++j) {
    x.rounded[j] = random.between(-1000, 1000) / 1024.0;
    x.exact[j] = rational_from_double(x.rounded[j]);
  }
  x.rounded[4] = 0;
  x.exact[4] = 0;
  return x;
}

TEST(DoubleModel, FunctionsAreWithinTheirErrors) {
  RandomSource random(341);
  for (int round = 0; round < 60; ++round) {
    const Problem problem = random_problem(random, 6);
    const DoubleModel model(problem);
    EXPECT_TRUE(model.is_moderate);
    ASSERT_EQ(model.contacts.size(), problem.size());
    double stiffness = 0;
    double arms = 0;
    for (std::size_t i = 0; i < problem.size(); ++i) {
      const ContactRow& row = problem.rows()[i];
      const ContactDoubles& c = model.contacts[i];
      stiffness += to_double(row.stiffness);
      const auto arm = [](const Wrench& w) { return to_double(w.torque); };
      arms += std::hypot(arm(row.normal), arm(row.tangent)) /
              std::hypot(to_double(row.normal.x), to_double(row.normal.y));
      EXPECT_EQ(c.frictionless, row.friction.is_zero());
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_DOUBLE_EQ(c.normal[j], to_double(coordinates(row.normal)[j]));
        EXPECT_DOUBLE_EQ(c.friction[j], to_double(row.friction * coordinates(row.tangent)[j]));
      }
      for (int k = 0; k < 5; ++k) {
        const Point x = random_point(random);
        const Rational v = dot(problem.separation(ContactId(i)), x.exact);
        const Rational off = v - rational_from_double(dot(c.separation, x.rounded));
        EXPECT_LE(abs(off), rational_from_double(c.separation_error));
        EXPECT_LE(c.separation_error, 1e-12);
        const Vector3 t = coordinates(row.tangent);
        const Rational slip = t[0] * x.exact[0] + t[1] * x.exact[1] + t[2] * x.exact[2];
        const Rational slip_off = slip - rational_from_double(dot(c.slip, x.rounded));
        EXPECT_LE(abs(slip_off), rational_from_double(c.slip_error));
      }
    }
    EXPECT_NEAR(model.stiffness, stiffness, 1e-9);
    if (arms > 0) {
      EXPECT_NEAR(model.length, arms / static_cast<double>(problem.size()), 1e-9);
    }
  }
}

TEST(DoubleModel, TellsNumbersThatAreTooLarge) {
  const auto with_friction = [](const Rational& friction) {
    ContactRow row{{0, 1, 0}, {-1, 0, 0}, friction, 1, 1};
    return DoubleModel(Problem({row}, {0, -1, 0}, NormalLaw::kUnilateral)).is_moderate;
  };
  const Rational large(Integer(1) << 200U);
  EXPECT_TRUE(with_friction(large));
  EXPECT_FALSE(with_friction(4 * large));
  EXPECT_TRUE(with_friction(0));
  EXPECT_FALSE(with_friction(1 / (4 * large)));
}

// Groups are a tree of all contacts. What a group says of its contacts is so: functions lie in
// its boxes, and its sums are theirs.
TEST(ContactGroups, BoxesAndSumsHoldTheirContacts) {
  RandomSource random(342);
  std::size_t with_parts = 0;
  for (int round = 0; round < 30; ++round) {
    const Problem problem = random_problem(random, round % 2 == 0 ? 6 : 150);
    const DoubleModel model(problem);
    const std::vector<ContactGroup>& groups = model.groups.groups();
    const std::vector<std::uint32_t>& order = model.groups.order();
    std::vector<char> seen(problem.size());
    for (const std::uint32_t contact : order) ++seen.at(contact);
    EXPECT_EQ(order.size(), problem.size());
    for (const char count : seen) EXPECT_EQ(count, 1);
    EXPECT_EQ(groups.front().begin, 0U);
    EXPECT_EQ(groups.front().end, problem.size());
    bool are_single = true;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const ContactGroup& group = groups[g];
      if (group.second != 0) {
        ++with_parts;
        EXPECT_EQ(groups[g + 1].begin, group.begin);
        EXPECT_EQ(groups[g + 1].end, groups[group.second].begin);
        EXPECT_EQ(groups[group.second].end, group.end);
      } else {
        are_single = are_single && group.end - group.begin == 1;
      }
      const Point x = random_point(random);
      const auto within = [&](const auto& box, const auto& function, double scale) {
        double middle = 0;
        double reach = box.error;
        double value = 0;
        for (std::size_t j = 0; j < box.center.size(); ++j) {
          middle += box.center[j] * x.rounded[j];
          reach += box.radius[j] * std::fabs(x.rounded[j]);
          value += function[j] * x.rounded[j] / scale;
        }
        EXPECT_LE(std::fabs(value - middle), reach + 1e-15);
      };
      ContactGroup sum;
      for (std::uint32_t k = group.begin; k < group.end; ++k) {
        const ContactDoubles& c = model.contacts[order[k]];
        const double size = std::hypot(c.normal[0], c.normal[1]);
        within(group.separation, c.separation, c.stiffness * size);
        within(group.slip, c.slip, size);
        within(group.friction, c.friction, size);
        EXPECT_GE(group.stiffest, c.stiffness * size * size * (1 - 1e-12));
        sum.is_frictionless = sum.is_frictionless && c.frictionless;
        sum.stiffness += c.stiffness;
        for (std::size_t j = 0; j < 5; ++j) {
          sum.law[j] += c.separation[j];
          for (std::size_t i = 0; i < 3; ++i) {
            sum.normal_work[i][j] += c.normal[i] * c.separation[j];
            sum.friction_work[i][j] += c.friction[i] * c.separation[j];
            sum.magnitude[i][j] += (std::fabs(c.normal[i]) + std::fabs(c.friction[i])) *
                                   std::fabs(c.separation[j]);
          }
        }
        if (group.has_one_slip_plane) {
          EXPECT_EQ(problem.slip_plane(ContactId(order[k])),
                    problem.slip_plane(ContactId(order[group.begin])));
        }
      }
      EXPECT_EQ(group.is_frictionless, sum.is_frictionless);
      EXPECT_NEAR(group.stiffness, sum.stiffness, 1e-9);
      for (std::size_t j = 0; j < 5; ++j) {
        EXPECT_NEAR(group.law[j], sum.law[j], 1e-9);
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_NEAR(group.normal_work[i][j], sum.normal_work[i][j], 1e-8);
          EXPECT_NEAR(group.friction_work[i][j], sum.friction_work[i][j], 1e-8);
          EXPECT_GE(group.magnitude[i][j], sum.magnitude[i][j] * (1 - 1e-9) - 1e-12);
        }
      }
    }
    EXPECT_EQ(model.groups.are_single(), are_single);
  }
  EXPECT_GE(with_parts, 50U);
}

TEST(ContactGroups, SignsOfShortVectorsAreExact) {
  RandomSource random(343);
  int unknown = 0;
  for (int round = 0; round < 300; ++round) {
    IntegerVector5 a;
    IntegerVector5 b;
    const unsigned bits = static_cast<unsigned>(random.between(1, 63));
    for (std::size_t j = 0; j < 5; ++j) {
      a[j] = (Integer(random.between(-2, 2)) << bits) / 2 + random.between(-1, 1);
      b[j] = Integer(random.between(-2, 2));
    }
    std::size_t longest = 0;
    for (const Integer& entry : a) {
      if (!entry.is_zero()) longest = std::max<std::size_t>(longest, msb(abs(entry)) + 1);
    }
    const auto sign = short_sign(ShortVector5(a), ShortVector5(b));
    EXPECT_EQ(sign.has_value(), longest <= 61);
    unknown += sign ? 0 : 1;
    if (sign) {
      EXPECT_EQ(*sign, dot(a, b).sign());
    }
  }
  EXPECT_GE(unknown, 5);
}

// The residual is the load with springs and with friction against the slip, up to its most; its
// derivative is that of nearby motions.
TEST(SmoothBalance, ResidualAndDerivative) {
  RandomSource random(344);
  for (int round = 0; round < 60; ++round) {
    const Problem problem = random_problem(random, 4);
    const DoubleModel model(problem);
    SmoothBalance balance(model);
    const double epsilon = 0.5;
    const double squeeze = random.one_in(2) ? 0.25 : 0;
    balance.set_epsilon(epsilon);
    balance.set_squeeze(squeeze);
    const auto entry = [&] { return random.between(-999, 999) / 1000.0; };
    const Eigen::Vector3d d(entry(), entry(), entry());
    Eigen::Vector3d expected(model.load[0], model.load[1], model.load[2]);
    bool is_smooth = true;  // no contact is near a change
    bool opens = false;
    for (const ContactRow& row : problem.rows()) {
      const auto along = [&](const Wrench& w) {
        return Eigen::Vector3d(to_double(w.x), to_double(w.y), to_double(w.torque));
      };
      const double gap =
          to_double(row.preload) - to_double(row.stiffness) * along(row.normal).dot(d);
      const double v = gap + squeeze;
      const double slip = along(row.tangent).dot(d);
      opens = opens || gap < -1e-3;
      is_smooth =
          is_smooth && std::fabs(v) > 1e-3 && std::fabs(std::fabs(slip) - epsilon) > 1e-3;
      if (v <= 0) continue;
      const double share = std::max(-1.0, std::min(1.0, -slip / epsilon));
      expected +=
          v * (along(row.normal) + share * to_double(row.friction) * along(row.tangent));
    }
    Eigen::Matrix3d derivative;
    const Eigen::Vector3d found = balance.residual(d, derivative);
    EXPECT_NEAR((found - expected).norm(), 0, 1e-9);
    if (!is_smooth) continue;
    EXPECT_EQ(balance.opens(d), opens);
    for (Eigen::Index j = 0; j < 3; ++j) {
      const double step = 1e-6;
      Eigen::Matrix3d unused;
      const Eigen::Vector3d change =
          balance.residual(d + step * Eigen::Vector3d::Unit(j), unused) -
          balance.residual(d - step * Eigen::Vector3d::Unit(j), unused);
      EXPECT_NEAR((change / (2 * step) - derivative.col(j)).norm(), 0, 1e-5);
    }
  }
}

/// The modes of an equilibrium.
std::vector<ModeGuess> modes_of(const Problem& problem, const Witness& witness) {
  std::vector<ModeGuess> guesses(problem.size());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactForce& force = witness.forces[i];
    ModeGuess& guess = guesses[i];
    guess.closed = !force.normal.is_zero();
    if (!guess.closed || row.friction.is_zero()) continue;
    guess.sticks = power(row.tangent, witness.twist).is_zero();
    guess.share = force.tangential / (row.friction * force.normal);
  }
  return guesses;
}

// The modes of an equilibrium lead back to one, and wrong ones to none that is no equilibrium.
TEST(WitnessSearch, CompletesModesExactly) {
  RandomSource random(345);
  int completed = 0;
  int refused = 0;
  int from_rest = 0;
  int stable_ones = 0;
  for (int round = 0; round < 150; ++round) {
    const auto m = static_cast<std::size_t>(random.between(2, 4));
    const Grasp grasp = test::generic_grasp(random, m);
    const bool planted = random.one_in(2);
    const Wrench load = planted ? test::planted_wrench(random, grasp, NormalLaw::kUnilateral)
                                : test::small_wrench(random);
    const Problem problem(LoadedGrasp{grasp, load}, NormalLaw::kUnilateral);
    const Verdict verdict = branch_and_bound(problem);
    const auto* stable = std::get_if<Stable>(&verdict);
    const DoubleModel model(problem);
    std::optional<MotionBox> otherwise;
    const auto found = find_witness_from_rest(problem, model, otherwise);
    if (stable == nullptr) {
      EXPECT_FALSE(found);
      continue;
    }
    ++stable_ones;
    from_rest += found ? 1 : 0;
    if (found) {
      EXPECT_FALSE(find_violation(problem, *found));
    }
    std::vector<ModeGuess> guesses = modes_of(problem, stable->witness());
    if (const auto again = complete_exactly(problem, guesses)) {
      ++completed;
      EXPECT_FALSE(find_violation(problem, *again));
      for (std::size_t i = 0; i < m; ++i) {
        EXPECT_EQ(guesses[i].closed, !again->forces[i].normal.is_zero());
      }
    }
    ModeGuess& wrong = guesses[static_cast<std::size_t>(random.between(0, 99)) % m];
    wrong.closed = !wrong.closed;
    wrong.sticks = wrong.closed;
    const auto other = complete_exactly(problem, guesses);
    refused += other ? 0 : 1;
    if (other) {
      EXPECT_FALSE(find_violation(problem, *other));
    }
  }
  EXPECT_GE(stable_ones, 60);
  EXPECT_GE(2 * completed, stable_ones);
  EXPECT_GE(3 * from_rest, stable_ones);
  EXPECT_GE(refused, 20);
}

TEST(WitnessSearch, RoundsSharesWithinTheirMost) {
  for (const double share : {-2.0, -1.0, -0.7, 0.0, 1e-9, 0.3333, 1.0, 1.5}) {
    const Rational rounded = rounded_share(share);
    EXPECT_LE(abs(rounded), 1);
    EXPECT_NEAR(to_double(rounded), std::max(-1.0, std::min(1.0, share)), 1e-3);
  }
}

// A twist that is confirmed refutes its region exactly; else a relaxed equilibrium balances it,
// with shares of friction in the cones, and is split at a contact.
TEST(CrowdForces, RefuteOrBalanceARegion) {
  RandomSource random(346);
  std::array<int, 3> seen{};
  for (int round = 0; round < 300; ++round) {
    const Problem problem = random_problem(random, 4);
    const DoubleModel model(problem);
    Region region = Region::root(problem);
    for (int splits = random.between(0, 3); splits > 0; --splits) {
      const ContactId contact(static_cast<std::size_t>(random.between(0, 99)) % problem.size());
      region = region.separation_child(
          problem, contact, random.one_in(3) ? Separation::kOpen : Separation::kClosed);
    }
    BranchWork work;
    planar_detail::CrowdForces forces(problem, model, nullptr, true, work);
    EXPECT_EQ(forces.enter(region, 1), !region.is_barred());
    EXPECT_EQ(work.nodes, 1U);
    if (region.is_barred()) continue;
    const planar_detail::SearchResult found = forces.nearest(true);
    EXPECT_FALSE(forces.may_try_again());
    if (found.separated) {
      const std::optional<Row> y = forces.confirm(found.twist);
      if (!y) continue;
      ++seen[0];
      EXPECT_TRUE(refutes(problem, region, TwistLeaf{*y}));
      continue;
    }
    ++seen[1];
    EXPECT_TRUE(forces.relaxation(region).has_value());
    forces.for_each_share(
        found, [](std::uint32_t) { return true; },
        [](std::uint32_t, double share) { EXPECT_LE(std::fabs(share), 1 + 1e-9); });
    const planar_detail::CrowdRelaxation relaxed = forces.relaxed(found);
    const auto branch = forces.split(relaxed);
    EXPECT_EQ(branch.has_value(), relaxed.broken.has_value());
    if (!branch) continue;
    ++seen[2];
    EXPECT_GT(relaxed.gap, 0);
    const bool is_slip = std::holds_alternative<SlipSplit>(branch->node);
    EXPECT_EQ(branch->children.size(), is_slip ? 3U : 2U);
  }
  for (const int count : seen) EXPECT_GE(count, 20);
}

}  // namespace double_model_test
}  // namespace stickslip
