// SPDX-License-Identifier: GPL-3.0-or-later
// The exact program of a region: leaves by the letter of the format, points by the model as
// problem.hpp states it, extents of multiples by leaves about what is beyond their ends.
#include "engine/planar/region_program.hpp"

#include <gtest/gtest.h>

#include <array>

#include "naive_region.hpp"
#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace region_program_test {

using test::NaiveRegion;
using test::RandomSource;
using test::Rays;

/// The same splits of a region and of its twin, for any range of multiples.
struct Split {
  std::size_t contact = 0;
  int slip = 2;  ///< 2: by separation
  bool closed = true;
};

std::vector<Split> random_splits(RandomSource& random, const Problem& problem) {
  std::vector<Split> splits;
  std::vector<char> labelled(problem.size());
  for (int count = random.between(0, 6); count > 0; --count) {
    Split split;
    split.contact =
        static_cast<std::size_t>(random.between(0, static_cast<int>(problem.size()) - 1));
    if (problem.law() == NormalLaw::kBilateral || random.one_in(2)) {
      split.slip = random.between(-1, 1);
      if (labelled[split.contact] != 0) continue;
      labelled[split.contact] = 1;
    } else {
      split.closed = !random.one_in(3);
    }
    splits.push_back(split);
  }
  return splits;
}

Region region_of(const Problem& problem, const std::vector<Split>& splits) {
  Region region = Region::root(problem);
  for (const Split& s : splits) {
    const ContactId contact(s.contact);
    region = s.slip == 2
                 ? region.separation_child(problem, contact,
                                           s.closed ? Separation::kClosed : Separation::kOpen)
                 : region.slip_child(problem, contact, sign_of_int(s.slip));
  }
  return region;
}

NaiveRegion naive_of(const Problem& problem, const std::vector<Split>& splits) {
  NaiveRegion region = NaiveRegion::root(problem);
  for (const Split& s : splits) {
    region = s.slip == 2 ? region.separation_child(problem, s.contact, s.closed)
                         : region.slip_child(problem, s.contact, s.slip);
  }
  return region;
}

Rays rays_of(const Problem& problem, const Region& region) {
  Rays rays;
  for (const Ray& ray : region.generators(problem)) rays.push_back(test::to_rational(ray.x));
  return rays;
}

/// A point lies in the region, balances, keeps friction in its cones, and is an equilibrium
/// unless a law is said to be broken, which it is where that is said.
void expect_relaxed(const Problem& problem, const NaiveRegion& region, const Rays& rays,
                    const RelaxedPoint& point) {
  const Twist& d = point.witness.twist;
  const Rational h = point.is_ray ? 0 : 1;
  const Vector5 x{d.x, d.y, d.r, h, point.multiple};
  for (const test::Constraint& constraint : region.constraints) {
    const bool is_l = constraint.sign == 0 && constraint.function == Vector5{0, 0, 0, 0, 1};
    EXPECT_TRUE(is_l || constraint.holds_at(x));
  }
  Wrench sum = h * problem.wrench() + point.multiple * problem.load_growth();
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const auto& [a, b] = point.witness.forces[i];
    sum += a * row.normal + b * row.tangent;
    EXPECT_GE(row.friction * a, abs(b));
    const std::optional<int> sign = naive_sign(problem, region, rays, i);
    if (sign) {
      EXPECT_EQ(b, -*sign * row.friction * a);
    }
    bool closed = true;
    bool open = true;
    for (const Vector5& ray : rays) {
      const int v = test::value_at(problem.separation(ContactId(i)), ray).sign();
      closed = closed && v >= 0;
      open = open && v <= 0;
    }
    const Rational v = test::value_at(problem.separation(ContactId(i)), x);
    if (closed) {
      EXPECT_EQ(a, v);
    } else if (open) {
      EXPECT_EQ(a, 0);
    }
  }
  EXPECT_EQ(sum, Wrench{});
  if (point.is_ray) return;
  const auto violation =
      find_violation(problem.is_family() ? problem.at(point.multiple) : problem, point.witness);
  EXPECT_EQ(violation.has_value(), point.broken.has_value()) << violation.value_or("");
  if (!point.broken) return;
  const auto* slip = std::get_if<SlipSplit>(&*point.broken);
  const std::size_t i =
      (slip != nullptr ? slip->contact : std::get<SeparationSplit>(*point.broken).contact)
          .index();
  const ContactRow& row = problem.rows()[i];
  const auto& [a, b] = point.witness.forces[i];
  if (slip != nullptr) {
    const Rational work = b * power(row.tangent, d);
    EXPECT_GT(work, -row.friction * a * abs(power(row.tangent, d)));
  } else {
    const Rational v = test::value_at(problem.separation(ContactId(i)), x);
    EXPECT_NE(a, v.sign() > 0 ? v : Rational(0));
  }
}

Problem random_problem(RandomSource& random) {
  const auto m = static_cast<std::size_t>(random.between(1, 4));
  const Grasp grasp =
      random.one_in(3) ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
  const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  const Wrench load =
      random.one_in(2) ? test::small_wrench(random) : test::planted_wrench(random, grasp, law);
  return Problem(LoadedGrasp{grasp, load}, law);
}

Problem random_family(RandomSource& random) {
  for (;;) {
    Wrench load = test::small_wrench(random);
    if (load == Wrench{}) load.y = 1;
    MultipleRange range{Rational(random.between(0, 3), 2), std::nullopt, random.one_in(2)};
    if (random.one_in(2)) range.high = range.low + Rational(random.between(1, 4), 3);
    return random_problem(random).along({row_of(load)}).within(range);
  }
}

TEST(RegionProgram, RefutesOrRelaxesARegion) {
  RandomSource random(101);
  std::array<int, 3> seen{};
  for (int round = 0; round < 700; ++round) {
    const Problem problem = round % 2 == 0 ? random_problem(random) : random_family(random);
    const std::vector<Split> splits = random_splits(random, problem);
    const Region region = region_of(problem, splits);
    if (region.is_barred()) continue;
    const NaiveRegion naive = naive_of(problem, splits);
    const Rays rays = rays_of(problem, region);
    LpWork work;
    const auto outcome = solve_region(problem, region, &work);
    if (const auto* leaf = std::get_if<TwistLeaf>(&outcome)) {
      ++seen[0];
      EXPECT_TRUE(naive_refutes(problem, naive, rays, *leaf));
      // A guess that refutes is returned as it is; one that does not leads to a leaf all the
      // same.
      TwistLeaf longer = *leaf;
      for (Integer& entry : longer.twist) entry *= 3;
      const auto same = solve_region(problem, region, nullptr, &longer);
      ASSERT_TRUE(std::holds_alternative<TwistLeaf>(same));
      EXPECT_EQ(std::get<TwistLeaf>(same).twist, longer.twist);
      for (Integer& entry : longer.twist) entry *= -1;
      const auto other = solve_region(problem, region, nullptr, &longer);
      ASSERT_TRUE(std::holds_alternative<TwistLeaf>(other));
      EXPECT_TRUE(naive_refutes(problem, naive, rays, std::get<TwistLeaf>(other)));
      continue;
    }
    const auto& point = std::get<RelaxedPoint>(outcome);
    ++seen[point.broken ? 1 : 2];
    expect_relaxed(problem, naive, rays, point);
  }
  for (const int count : seen) EXPECT_GE(count, 60);
}

// Points at both ends satisfy the relaxed system; beyond them, and without them, a leaf says
// that nothing does.
TEST(RegionProgram, NothingIsBeyondTheExtentOfMultiples) {
  RandomSource random(103);
  std::array<int, 3> seen{};
  for (int round = 0; round < 1200; ++round) {
    const Problem problem = random_family(random);
    const std::vector<Split> splits = random_splits(random, problem);
    const Region region = region_of(problem, splits);
    if (region.is_barred()) continue;
    const auto expect_refuted = [&](const MultipleRange& range) {
      const Problem beyond = problem.within(range);
      const Region rest = region_of(beyond, splits);
      if (rest.is_barred()) return;
      const auto outcome = solve_region(beyond, rest, nullptr);
      const auto* leaf = std::get_if<TwistLeaf>(&outcome);
      ASSERT_NE(leaf, nullptr);
      EXPECT_TRUE(
          naive_refutes(beyond, naive_of(beyond, splits), rays_of(beyond, rest), *leaf));
    };
    const MultipleRange& range = problem.multiples();
    const auto extent = multiple_extent(problem, region);
    if (!extent) {
      ++seen[0];
      expect_refuted(range);
      continue;
    }
    const NaiveRegion naive = naive_of(problem, splits);
    const Rays rays = rays_of(problem, region);
    expect_relaxed(problem, naive, rays, extent->lowest);
    expect_relaxed(problem, naive, rays, extent->highest);
    EXPECT_GE(extent->lowest.multiple, range.low);
    if (extent->lowest.multiple > range.low) {
      ++seen[1];
      expect_refuted({range.low, extent->lowest.multiple, true});
    }
    if (extent->highest.is_ray) continue;
    EXPECT_GE(extent->highest.multiple, extent->lowest.multiple);
    if (!range.high || extent->highest.multiple < *range.high) {
      ++seen[2];
      expect_refuted({extent->highest.multiple, range.high, false});
    }
  }
  for (const int count : seen) EXPECT_GE(count, 20);
}

}  // namespace region_program_test
}  // namespace stickslip
