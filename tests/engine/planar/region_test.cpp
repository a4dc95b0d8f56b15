// SPDX-License-Identifier: GPL-3.0-or-later
// Regions, labels, strict functions and leaves (certificate/FORMAT.md, section 4).
#include "engine/planar/region.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/planar/find_flaw.hpp"
#include "naive_region.hpp"
#include "paper_grasps.hpp"
#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::fig1_grasp;
using test::fig4_grasp;
using test::NaiveRegion;
using test::RandomSource;
using test::Rays;
using test::to_rational;

constexpr ContactId kFirst(0);
constexpr ContactId kSecond(1);
constexpr ContactId kThird(2);

Problem fig4(const Rational& preload, NormalLaw law = NormalLaw::kUnilateral) {
  return Problem({fig4_grasp(preload), {0, 2, 0}}, law);
}

Rays rays_of(const Problem& problem, const Region& region) {
  Rays rays;
  for (const Ray& ray : region.generators(problem)) rays.push_back(to_rational(ray.x));
  return rays;
}

TEST(Problem, LinearFunctionsOfTheHomogenisedMotion) {
  // p = (2, 1), n = (3, 4), L = 5: N = (3, 4, 5), T = (-4, 3, 10), P/L = 2, k/L^2 = 1/5.
  const Grasp grasp({{{2, 1}, {3, 4}, {1, 2}, 5, 10}});
  const Problem problem({grasp, {1, 2, 3}}, NormalLaw::kUnilateral);
  EXPECT_EQ(problem.slip_plane(kFirst), (IntegerVector5{-4, 3, 10, 0, 0}));
  EXPECT_EQ(problem.separation(kFirst),
            (Vector5{Rational(-3, 5), Rational(-4, 5), Rational(-1), Rational(2), 0}));
  EXPECT_EQ(problem.separation_plane(kFirst), (IntegerVector5{-3, -4, -5, 10, 0}));
  const Wrench n{3, 4, 5};
  const Wrench t{-4, 3, 10};
  for (const int sigma : {-1, 0, 1}) {
    EXPECT_EQ(problem.edge_wrench(kFirst, sigma), n + Rational(sigma, 2) * t);
  }
}

TEST(Problem, PreloadNeedsANormalOfRationalLength) {
  const std::vector<Contact> contacts = {{{0, 0}, {1, 0}, 0, 1, 1}, {{0, 1}, {1, 1}, 0, 1, 1}};
  try {
    const Problem problem({Grasp(contacts), {}}, NormalLaw::kUnilateral);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "contacts[1].normal");
  }
}

// Though most of them cut nothing, and whatever the order.
TEST(Region, BilateralRootIsCutByAllContacts) {
  RandomSource random(11);
  const auto sorted_rays = [](const Cone& cone) {
    std::vector<IntegerVector5> rays;
    for (const Ray& ray : cone.rays()) rays.push_back(ray.x);
    std::sort(rays.begin(), rays.end());
    return rays;
  };
  for (int round = 0; round < 300; ++round) {
    const auto contacts = static_cast<std::size_t>(random.between(1, 12));
    const Grasp grasp = random.one_in(2) ? test::degenerate_grasp(random, contacts)
                                         : test::generic_grasp(random, contacts);
    const Problem problem({grasp, {1, 2, 3}}, NormalLaw::kBilateral);
    Cone naive;
    for (std::size_t i = 0; i < problem.size(); ++i) {
      naive.cut(problem.separation_plane(ContactId(i)), Side::kPositive);
    }
    const Region root = Region::root(problem);
    ASSERT_EQ(root.cone().lines().size(), naive.lines().size());
    EXPECT_EQ(root.cone().rays().size(), naive.rays().size());
    if (!naive.lines().empty()) continue;  // modulo lines rays have no one form
    EXPECT_EQ(sorted_rays(root.cone()), sorted_rays(naive));
  }
}

TEST(Region, SeparationChildren) {
  const Problem problem = fig4(1);
  const Region root = Region::root(problem);
  const Region closed = root.separation_child(problem, kFirst, Separation::kClosed);
  EXPECT_EQ(closed.separation(problem, kFirst), Separation::kClosed);
  EXPECT_EQ(closed.separation(problem, kSecond), Separation::kMixed);
  const Region open = root.separation_child(problem, kFirst, Separation::kOpen);
  EXPECT_EQ(open.separation(problem, kFirst), Separation::kOpen);
  // Points with v = 0 are closed; among the open ones they are nobody's.
  EXPECT_FALSE(closed.separation_child(problem, kFirst, Separation::kClosed).is_barred());
  EXPECT_TRUE(closed.separation_child(problem, kFirst, Separation::kOpen).is_barred());
  EXPECT_TRUE(open.separation_child(problem, kFirst, Separation::kClosed).is_barred());
  EXPECT_THROW(root.separation_child(problem, kFirst, Separation::kMixed), ContractError);
  EXPECT_THROW(root.plane_child({1, 0, 0, 0}, Side::kZero), ContractError);
}

TEST(Region, WithSlipStateIsTheClosedCell) {
  const Problem problem = fig4(1);
  const Region root = Region::root(problem);
  const std::vector<Sign> state = {Sign::kPositive, Sign::kPositive, Sign::kZero, Sign::kZero};
  const Region cell = root.with_slip_state(problem, state);
  EXPECT_FALSE(cell.is_barred());
  for (std::size_t i = 0; i < state.size(); ++i) {
    EXPECT_EQ(cell.label(ContactId(i)), state[i]);
    const SignRange range = ConeSigns(cell.cone()).on(problem.slip_plane(ContactId(i)));
    EXPECT_EQ(range.is_zero(), state[i] == Sign::kZero);
    EXPECT_TRUE(range.is_nonnegative());
  }
  EXPECT_THROW(root.with_slip_state(problem, {Sign::kZero}), ContractError);
}

// Fig. 4, P = 1, nothing slips: then d = (x, 0, 0), and while nothing opens the normal forces
// are 1 - x and 1 + x, so that friction resists |w_y| <= 4 mu = 2.
TEST(Leaf, BoundIsExactAtTheThreshold) {
  const Rational tiny(1, Integer("1000000000000000000"));
  for (const Rational& excess : {Rational(-tiny), Rational(0), tiny}) {
    const Problem problem({fig4_grasp(1), {0, 2 + excess, 0}}, NormalLaw::kUnilateral);
    const Region stuck = Region::root(problem)
                             .slip_child(problem, kFirst, Sign::kZero)
                             .slip_child(problem, kThird, Sign::kZero)
                             .plane_child({1, 0, 0, 1}, Side::kPositive)
                             .plane_child({-1, 0, 0, 1}, Side::kPositive);
    const TwistLeaf down{{0, -1, 0}};
    for (const Rational& bound : work_bounds(problem, stuck, down)) {
      EXPECT_EQ(bound, -excess);
    }
    EXPECT_EQ(refutes(problem, stuck, down), excess > 0);
    EXPECT_FALSE(refutes(problem, stuck, {{0, 1, 0}}));
    EXPECT_FALSE(refutes(problem, stuck, {{0, 0, 0}}));
  }
}

/// Any split that a tree may make, and some that it would not.
void split_at_random(RandomSource& random, const Problem& problem, Region& region,
                     NaiveRegion& naive) {
  const std::size_t contact =
      static_cast<std::size_t>(random.between(0, static_cast<int>(problem.size()) - 1));
  const int kind = random.between(0, problem.law() == NormalLaw::kUnilateral ? 4 : 3);
  if (kind <= 2 && !naive.labels[contact]) {
    const int slip = random.between(-1, 1);
    region = region.slip_child(problem, ContactId(contact), sign_of_int(slip));
    naive = naive.slip_child(problem, contact, slip);
  } else if (kind == 3) {
    IntegerVector5 plane;
    for (Integer& entry : plane) entry = random.between(-1, 1);
    if (problem.is_family() && !problem.preloads_grow()) {
      IntegerVector5 any = plane;
      any[4] = 1;
      EXPECT_THROW(region.plane_child(any, Side::kPositive), ContractError);
      plane[4] = 0;
    }
    const bool first = random.one_in(2);
    region = region.plane_child(plane, first ? Side::kPositive : Side::kNegative);
    naive = naive.plane_child(to_rational(plane), first);
  } else if (kind == 4) {
    const bool closed = random.one_in(2);
    region = region.separation_child(problem, ContactId(contact),
                                     closed ? Separation::kClosed : Separation::kOpen);
    naive = naive.separation_child(problem, contact, closed);
  }
}

/// With growing loads, growing preloads or both, and a range of any sort.
Problem random_family(RandomSource& random, const Problem& problem) {
  Growth growth;
  Wrench load{};
  if (random.one_in(2)) load = test::small_wrench(random);
  if (random.one_in(2)) {
    for (std::size_t i = 0; i < problem.size(); ++i) {
      growth.preloads.emplace_back(random.between(0, 2));
    }
  }
  const bool grows =
      !(load == Wrench{}) || std::any_of(growth.preloads.begin(), growth.preloads.end(),
                                         [](const Rational& p) { return !p.is_zero(); });
  if (!grows) load.x = 1;
  growth.load = row_of(load);
  MultipleRange range{Rational(random.between(0, 3), 2), std::nullopt, random.one_in(2)};
  if (random.one_in(2)) range.high = range.low + Rational(random.between(1, 4), 3);
  return problem.along(growth).within(range);
}

TwistLeaf random_leaf(RandomSource& random) {
  TwistLeaf leaf{Row(3)};
  for (Integer& entry : leaf.twist) entry = random.between(-2, 2);
  return leaf;
}

// The rules of section 4, each broken once by a tree that ends there.
TEST(FindFlaw, EachRuleIsAsked) {
  const Problem problem = fig4(1);
  const auto flaw = [&](const Trees& tree) { return find_flaw(problem, tree).value_or(""); };
  const TwistLeaf leaf{{0, 0, 0}};
  EXPECT_EQ(flaw({}), "the tree ends before all children are there");
  EXPECT_EQ(flaw({SlipSplit{ContactId(problem.size())}}), "node 0: no such contact");
  EXPECT_EQ(flaw({SeparationSplit{ContactId(problem.size())}}), "node 0: no such contact");
  EXPECT_EQ(flaw({SlipSplit{kFirst}, SlipSplit{kFirst}}),
            "node 1: a second slip split of one contact");
  EXPECT_EQ(flaw({PlaneCut{{0, 0, 0, 0, 0}}}), "node 0: a plane without a normal");
  EXPECT_EQ(flaw({leaf}), "node 0: the twist does not refute the region");
  EXPECT_EQ(find_flaw(fig4(1, NormalLaw::kBilateral), {SeparationSplit{kFirst}}),
            "node 0: a separation under the bilateral law");
}

// Refuting leaves are rare among random ones; planted ones come from the engine, and every test
// that decides compares them in the same way (check_refutation).
TEST(Region, AgreesWithTheLetterOfTheFormat) {
  RandomSource random(11);
  int voids = 0;
  int refuted = 0;
  for (int round = 0; round < 1500; ++round) {
    const auto m = static_cast<std::size_t>(random.between(1, 3));
    const Grasp grasp =
        random.one_in(4) ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
    const Wrench wrench = test::small_wrench(random);
    const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    SCOPED_TRACE(test::describe({{grasp, wrench}, law}));
    Problem problem({grasp, wrench}, law);
    if (random.one_in(2)) problem = random_family(random, problem);
    Region region = Region::root(problem);
    NaiveRegion naive = NaiveRegion::root(problem);
    for (int splits = random.between(0, 6); splits > 0; --splits) {
      split_at_random(random, problem, region, naive);
    }
    const Rays rays = rays_of(problem, region);
    const Rays brute = test::brute_force_generators(naive.constraints).directions();
    const bool is_void = naive_is_barred(naive, rays);
    EXPECT_EQ(naive_is_barred(naive, brute), is_void) << "the rays should not matter";
    EXPECT_EQ(region.is_barred(), is_void);
    voids += is_void ? 1 : 0;
    for (std::size_t i = 0; i < m; ++i) {
      const std::optional<Sign> sign = region.slip_sign(problem, ContactId(i));
      const std::optional<int> expected = naive_sign(problem, naive, rays, i);
      ASSERT_EQ(sign.has_value(), expected.has_value());
      if (sign) {
        EXPECT_EQ(to_int(*sign), *expected);
      }
      const std::optional<Sign> label = region.label(ContactId(i));
      EXPECT_EQ(label ? std::optional<int>(to_int(*label)) : std::nullopt, naive.labels[i]);
    }
    for (int leaves = 0; leaves < 4; ++leaves) {
      const TwistLeaf leaf = random_leaf(random);
      EXPECT_EQ(work_bounds(problem, region, leaf), naive_bounds(problem, naive, rays, leaf));
      const bool holds = naive_refutes(problem, naive, rays, leaf);
      EXPECT_EQ(refutes(problem, region, leaf), holds);
      EXPECT_EQ(naive_refutes(problem, naive, brute, leaf), holds);
      refuted += holds && !is_void ? 1 : 0;
    }
  }
  EXPECT_GT(voids, 100);
  EXPECT_GT(refuted, 100);
}

}  // namespace
}  // namespace stickslip
