// SPDX-License-Identifier: GPL-3.0-or-later
// What is found of contacts in groups, against a look at each of them in rationals.
#include "engine/planar/region_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/planar/twist_search.hpp"
#include "random_grasps.hpp"

namespace stickslip {
namespace {

using namespace planar_detail;
using test::RandomSource;

struct Seen {
  std::size_t decided = 0;
  std::size_t single = 0;
  std::size_t in_groups = 0;
  std::size_t confirmed = 0;
};

/// What is said of every contact is so, and none that acts is left out.
void compare(const Problem& problem, const Region& region, const RegionForces& forces,
             Seen& seen) {
  const std::vector<Ray> rays = region.generators(problem);
  ASSERT_EQ(rays.size(), forces.ray_count());
  const auto sign_at = [&](ContactId contact, std::size_t ray) {
    return dot(problem.separation_plane(contact), rays[ray].x).sign();
  };
  std::map<std::size_t, ContactFreedom> undecided;
  for (std::size_t k = 0; k < forces.undecided().size(); ++k) {
    const UndecidedGroup& u = forces.undecided()[k];
    std::vector<std::uint32_t> contacts;
    forces.for_each_contact(u, [&](std::uint32_t contact) { contacts.push_back(contact); });
    (contacts.size() == 1 ? seen.single : seen.in_groups) += contacts.size();
    for (const std::uint32_t contact : contacts) {
      EXPECT_TRUE(undecided.emplace(contact, u.freedom).second);
    }
    for (std::size_t r = 0; r < rays.size(); ++r) {
      const BlockForces& sums = forces.block_forces(k)[r / kBlock];
      bool pushes = false;
      Rational normal = 0;
      Rational friction = 0;
      Rational pressing = 0;
      for (const std::uint32_t contact : contacts) {
        const ContactId id(contact);
        pushes = pushes || sign_at(id, r) > 0;
        Rational v = 0;
        for (std::size_t j = 0; j < 5; ++j) v += problem.separation(id)[j] * rays[r].x[j];
        if (v.sign() <= 0) continue;
        pressing += v;
        normal += v * problem.row(id).normal.torque;
        friction += v * problem.row(id).friction * problem.row(id).tangent.torque;
      }
      EXPECT_EQ(sums.pushes.data()[r % kBlock], pushes ? 1 : 0);
      // The ray in doubles is scaled.
      double scale = 1;
      for (std::size_t j = 0; j < 5; ++j) {
        if (!rays[r].x[j].is_zero()) {
          scale = forces.rays()[r][j] / to_double(Rational(rays[r].x[j]));
        }
      }
      const auto expect_near = [&](const BlockDoubles& sum, const Rational& exact) {
        const double expected = scale * to_double(exact);
        EXPECT_NEAR(sum.data()[r % kBlock], expected, 1e-9 * (1 + std::fabs(expected)));
      };
      expect_near(sums.pressing, pressing);
      expect_near(sums.normal[2], normal);
      expect_near(sums.friction[2], friction);
    }
  }
  Rational sum[3][5];
  std::vector<bool> acts_at(rays.size());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactId contact(i);
    bool acts = false;
    for (std::size_t r = 0; r < rays.size(); ++r) acts = acts || sign_at(contact, r) > 0;
    const auto found = undecided.find(i);
    if (!acts) {  // open, or v = 0, where there is no force
      EXPECT_TRUE(found == undecided.end());
      continue;
    }
    const Separation separation = region.separation(problem, contact);
    ASSERT_NE(separation, Separation::kOpen);
    const int slip = to_int(region.slip_sign(problem, contact).value_or(Sign::kZero));
    const bool has_edge = slip != 0 || problem.row(contact).friction.is_zero();
    if (found != undecided.end()) {
      EXPECT_EQ(found->second.separation, separation);
      // Without friction slip is as good as decided, which is not seen of every group.
      if (!problem.row(contact).friction.is_zero()) {
        EXPECT_EQ(found->second.slip, slip);
        EXPECT_FALSE(found->second.is_closed() && slip != 0);
      }
      continue;
    }
    ++seen.decided;
    ASSERT_EQ(separation, Separation::kClosed);
    ASSERT_TRUE(has_edge);
    for (std::size_t r = 0; r < rays.size(); ++r) {
      if (sign_at(contact, r) > 0) acts_at[r] = true;
    }
    const Vector3 edge = coordinates(problem.edge_wrench(contact, -slip));
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 5; ++k) sum[j][k] += edge[j] * problem.separation(contact)[k];
    }
  }
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const bool grows = !(problem.load_growth() == Wrench{}) && !rays[r].x[4].is_zero();
    EXPECT_EQ(forces.loaded(r), acts_at[r] || !rays[r].x[3].is_zero() || grows);
    for (std::size_t j = 0; j < 3; ++j) {
      Rational exact = 0;
      double found = 0;
      for (std::size_t k = 0; k < 5; ++k) {
        exact += sum[j][k] * Rational(rays[r].x[k]);
        found += forces.decided().value[j][k] * to_double(Rational(rays[r].x[k]));
      }
      EXPECT_NEAR(found, to_double(exact), 1e-9 * (1 + std::fabs(found)));
    }
  }
}

/// Twists that doubles confirm refute the region in rationals, too.
void confirm_twists(const Problem& problem, const DoubleModel& model, const Region& region,
                    const RegionForces& forces, RandomSource& random, Seen& seen) {
  TwistSearch search(model);
  BranchWork work;
  std::vector<Double3> twists;
  for (const bool precisely : {false, true}) {
    const SearchResult found = search.search(forces, precisely, work);
    if (found.separated) twists.push_back(found.twist);
  }
  for (int k = 0; k < 3; ++k) {
    twists.push_back({static_cast<double>(random.between(-9, 9)),
                      static_cast<double>(random.between(-9, 9)),
                      static_cast<double>(random.between(-9, 9))});
  }
  for (const Double3& twist : twists) {
    const auto leaf = search.confirm(problem, region, forces, twist, work, false);
    if (!leaf) continue;
    ++seen.confirmed;
    EXPECT_TRUE(refutes(problem, region, TwistLeaf{*leaf}));
  }
}

void compare_on_regions(std::size_t most_contacts, int trials, std::size_t smallest,
                        Seen& seen) {
  RandomSource random(31);
  for (int trial = 0; trial < trials; ++trial) {
    const Grasp grasp = test::degenerate_grasp(
        random, static_cast<std::size_t>(random.between(1, static_cast<int>(most_contacts))));
    Problem problem({grasp, test::small_wrench(random)},
                    random.between(0, 3) == 0 ? NormalLaw::kBilateral : NormalLaw::kUnilateral);
    if (random.between(0, 3) == 0) {
      Growth growth{{1, Rational(random.between(-3, 3)), 0}, {}};
      if (random.between(0, 1) == 0) growth.preloads.assign(problem.size(), Rational(1, 2));
      problem = problem.along(growth);
    }
    DoubleModel model(problem);
    model.groups = ContactGroups(problem, model.contacts, model.length, smallest);
    if (random.between(0, 5) == 0) model.is_moderate = false;  // then doubles decide nothing
    RegionForces forces(problem, model);
    Region region = Region::root(problem);
    for (int depth = 0; depth < 6 && !region.is_barred(); ++depth) {
      forces.read(region);
      compare(problem, region, forces, seen);
      confirm_twists(problem, model, region, forces, random, seen);
      std::vector<std::pair<ContactId, ContactFreedom>> undecided;
      for (const UndecidedGroup& u : forces.undecided()) {
        forces.for_each_contact(u, [&](std::uint32_t contact) {
          undecided.emplace_back(ContactId(contact), u.freedom);
        });
      }
      if (undecided.empty()) break;
      const auto last = static_cast<int>(undecided.size()) - 1;
      const auto& [contact, freedom] =
          undecided[static_cast<std::size_t>(random.between(0, last))];
      if (!freedom.is_closed()) {
        region = region.separation_child(
            problem, contact,
            random.between(0, 1) == 0 ? Separation::kClosed : Separation::kOpen);
      } else if (freedom.slip == 0 && freedom.slip_cuts) {
        region = region.slip_child(problem, contact, sign_of_int(random.between(-1, 1)));
      }
    }
  }
}

TEST(RegionForces, SaysOfSingleContactsWhatIsSo) {
  Seen seen;
  compare_on_regions(6, 400, 1, seen);
  EXPECT_GT(seen.decided, 500U);
  EXPECT_GT(seen.single, 500U);
  EXPECT_EQ(seen.in_groups, 0U);
}

TEST(RegionForces, SaysOfGroupsWhatIsSoOfEachContact) {
  Seen seen;
  for (const std::size_t smallest : {1, 2, 5}) compare_on_regions(60, 100, smallest, seen);
  EXPECT_GT(seen.decided, 500U);
  EXPECT_GT(seen.single, 500U);
  EXPECT_GT(seen.in_groups, 500U);
  EXPECT_GT(seen.confirmed, 200U);
}

/// Evenly, in about, round an ellipse, with inward normals.
Grasp ellipse(int count) {
  std::vector<Contact> contacts;
  for (int k = 0; k < count; ++k) {
    const Rational t(2 * k + 1 - count, count);  // the tangent of a quarter of the angle
    const Rational half = 2 * t / (1 - t * t);
    const Rational c = (1 - half * half) / (1 + half * half);
    const Rational s = 2 * half / (1 + half * half);
    Contact contact;
    contact.position = {2 * c, s};
    contact.normal = {-c, -2 * s};
    contact.friction = Rational(1, 2);
    contacts.push_back(contact);
  }
  return Grasp(std::move(contacts));
}

TEST(RegionForces, LooksAtFewOfManyContactsThatAreAlikeBesideEachOther) {
  std::vector<double> visits;
  for (const int count : {512, 4096}) {
    const Problem problem({ellipse(count), {1, 2, 3}}, NormalLaw::kUnilateral);
    const DoubleModel model(problem);
    RegionForces forces(problem, model);
    Region region = Region::root(problem);
    for (const int at : {0, count / 3}) {
      region =
          region.slip_child(problem, ContactId(static_cast<std::size_t>(at)), Sign::kPositive);
    }
    forces.read(region);
    visits.push_back(static_cast<double>(forces.visits()));
    EXPECT_LT(forces.visits(), 300U);
  }
  EXPECT_LT(visits[1], 1.7 * visits[0]);  // 8 levels of groups, and 5
}

}  // namespace
}  // namespace stickslip
