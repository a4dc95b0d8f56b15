// SPDX-License-Identifier: GPL-3.0-or-later
// What is exact in the engine, each part alone and where it is seldom asked: the checker, which
// shares nothing with it, accepts all that is proved, and what is planted is found.
#include <gtest/gtest.h>

#include <algorithm>

#include "both_checkers.hpp"
#include "engine/degree/exact_witness.hpp"
#include "engine/search/exact_region.hpp"
#include "engine/search/law_forces.hpp"
#include "engine/search/relaxed_region.hpp"
#include "random_grasps.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip {
namespace {

using test::RandomSource;

std::string texts(const RationalRow& numbers) {
  std::string result;
  for (const Rational& x : numbers) result += (result.empty() ? "[\"" : ", \"") + x.str() + '"';
  return result + "]";
}

/// One body, as if there were several, and what is nearly an equilibrium.
struct Body {
  std::string contacts{};
  RationalRow wrench{};
  QuestionOptions options{};
  NearEquilibrium near{};
  bool is_planted = false;  ///< it is one, with room on all sides

  void add(const RationalRow& position, const RationalRow& normal, const RationalRow& laws) {
    contacts += (contacts.empty() ? "" : ", ") + std::string(R"({"of": "body", "position": )") +
                texts(position) + R"(, "normal": )" + texts(normal);
    for (std::size_t k = 0; k < laws.size(); ++k) {
      constexpr const char* kNames[] = {"friction", "preload", "stiffness", "torsion"};
      contacts += std::string(", \"") + kNames[k] + R"(": ")" + laws[k].str() + '"';
    }
    contacts += "}";
  }
  std::string file() const {
    return R"({"format": "stickslip-grasp/3", "bodies": [{"name": "body"}], "contacts": [)" +
           contacts + R"(], "wrench": )" + texts(wrench) + "}";
  }
  Question question() const { return ask(parse_any_grasp(file(), "one body"), options); }
  GraspLaw law() const { return law_of(question(), kDefaultBits); }
  void expect_accepted(const Verdict& verdict) const {
    test::expect_accepted_by_both(
        {file(), certificate_text(question(), verdict, "a test"), options});
  }
};

/// The load is such that the body is in equilibrium, with a motion without slip of some
/// contacts.
Body planted(RandomSource& random, bool in_space) {
  Body body;
  if (random.one_in(4)) body.options.law = NormalLaw::kBilateral;
  body.wrench.resize(in_space ? 6 : 3);
  for (int i = random.between(1, 4); i > 0; --i) {
    RationalRow position;
    for (int j = in_space ? 3 : 2; j > 0; --j) position.emplace_back(random.between(-4, 4), 2);
    RationalRow normal = in_space ? RationalRow{0, Rational(3, 5), Rational(4, 5)}
                                  : RationalRow{Rational(3, 5), Rational(-4, 5)};
    if (random.one_in(2)) normal = in_space ? RationalRow{1, -2, 2} : RationalRow{0, 1};
    RationalRow laws{Rational(random.between(0, 2), 2), random.between(0, 2),
                     random.between(1, 2)};
    if (in_space && random.one_in(2)) laws.emplace_back(1, 3);
    body.add(position, normal, laws);
  }
  const GraspLaw law = body.law();
  std::vector<RationalRow> slips;
  for (const LawContact& c : law.contacts) {
    if (c.friction.low.is_zero() || (!in_space && random.one_in(2))) continue;
    for (const Row& row : c.corners.front().slip) slips.emplace_back(row.begin(), row.end());
  }
  RationalRow d(law.motions);
  for (const RationalRow& way : null_space(matrix_of(slips, law.motions))) {
    add_multiple(d, Rational(random.between(-2, 2), 4), way);
  }
  body.near.motion.resize(static_cast<Eigen::Index>(d.size()));
  for (std::size_t j = 0; j < d.size(); ++j) {
    body.near.motion[static_cast<Eigen::Index>(j)] = to_double(d[j]);
  }
  law.scale(body.near.motion);
  body.is_planted = true;
  const bool moves =
      std::any_of(d.begin(), d.end(), [](const Rational& entry) { return !entry.is_zero(); });
  for (const LawContact& c : law.contacts) {
    const CornerRow& row = c.corners.front();
    Rational v = c.preload.low - c.stiffness.low * dot(row.normal, d);
    const bool may_open = body.options.law == NormalLaw::kUnilateral;
    if (v.is_zero() ? moves : v.sign() < 0 && !may_open) body.is_planted = false;
    if (v.sign() < 0) v = 0;
    const int slip = in_space ? 0 : dot(row.wrench_of({1}), d).sign();
    RationalRow f(c.slip_numbers());
    Double3 rounded{};
    for (std::size_t k = 0; k < c.directions.size(); ++k) {
      const Rational share = slip == 0 ? Rational(random.between(-4, 4), 9) : Rational(-slip);
      const Rational part = c.friction.low * v * share;
      for (std::size_t j = 0; j < f.size(); ++j) f[j] += part * c.directions[k][j];
      rounded[k] = to_double(part) * c.direction_sizes[k];
    }
    const Rational most = c.friction.low * v;
    const bool has_room = 10 * c.squared_force(f) <= 9 * most * most * c.squared_length;
    if (slip == 0 && !has_room) body.is_planted = false;
    const RationalRow wrench = row.wrench_of(f);
    for (std::size_t j = 0; j < d.size(); ++j) {
      body.wrench[j] -= v * row.normal[j] + wrench[j];
    }
    body.near.normal.push_back(to_double(v));
    body.near.friction.push_back(rounded);
    body.near.sticks.push_back(slip == 0 ? 1 : 0);
  }
  return body;
}

// A tree of which each node is decided exactly ends, and so in a proof.
TEST(ExactRegions, EndInAProof) {
  RandomSource random(21);
  std::array<int, 2> seen{};
  for (int round = 0; round < 200; ++round) {
    Body body = planted(random, false);
    if (random.one_in(2)) body.wrench[static_cast<std::size_t>(round % 3)] += 1;
    SCOPED_TRACE(body.file());
    const GraspLaw law = body.law();
    SearchWork work;
    LawForces forces(law, nullptr, work);
    std::optional<ShareWitness> witness;
    Trees tree;
    const bool refuted = append_tree(
        MotionRegion::root(law), tree,
        [&](const MotionRegion& region, std::size_t depth) -> std::optional<LawForces::Branch> {
          constexpr std::size_t kMany = 2000;
          if (tree.size() > kMany) return std::nullopt;
          if (!forces.enter(region, depth))
            return LawForces::Branch{TwistLeaf{Row(law.motions)}, {}};
          auto found = decide_exactly(law, region);
          if (auto* node = std::get_if<TreeNode>(&found)) return forces.branch(*node);
          witness = std::move(std::get<ShareWitness>(found));
          return std::nullopt;
        });
    ASSERT_NE(refuted, witness.has_value());
    ++seen[refuted ? 1 : 0];
    if (refuted) body.expect_accepted(Unstable{std::move(tree)});
    if (witness) body.expect_accepted(Stable{*witness, witness->twist});
  }
  EXPECT_GE(std::min(seen[0], seen[1]), 40);
}

TEST(ExactRegions, AreRefutedIfTheyAreEmpty) {
  RelaxedRegion empty(6, {});
  LpWork work;
  const auto found = empty.solve(work);
  ASSERT_TRUE(std::holds_alternative<RationalRow>(found));
  EXPECT_EQ(std::get<RationalRow>(found), RationalRow(6));
  EXPECT_TRUE(empty.bounds(RationalRow(6)).empty());
  EXPECT_FALSE(empty.extreme(1, work));
}

// A hull of one load, which all generators carry, is decided as the load itself.
TEST(ExactRegions, AHullOfOneLoadIsThatLoad) {
  RandomSource random(22);
  std::array<int, 2> seen{};
  for (int round = 0; round < 200; ++round) {
    Body body = planted(random, false);
    if (random.one_in(2)) body.wrench[static_cast<std::size_t>(round % 3)] += 1;
    SCOPED_TRACE(body.file());
    const GraspLaw law = body.law();
    Law of_hull = law;
    RationalRow load;
    for (Interval& component : of_hull.wrench) {
      load.push_back(component.low);
      component = Interval{};
    }
    of_hull.hull.emplace().corners.push_back({load, {}});
    of_hull.complete_loads();
    const auto expected = decide_exactly(law, MotionRegion::root(law));
    const MotionRegion region = MotionRegion::root(of_hull);
    const auto found = decide_exactly(of_hull, region);
    ASSERT_EQ(found.index(), expected.index());
    if (found.index() == 1) continue;
    const auto& node = std::get<TreeNode>(found);
    const auto& other = std::get<TreeNode>(expected);
    ASSERT_EQ(node.index(), other.index());
    const auto* leaf = std::get_if<TwistLeaf>(&node);
    ++seen[leaf != nullptr ? 1 : 0];
    if (leaf != nullptr) {
      EXPECT_TRUE(region.is_refuted(leaf->twist, nullptr));
    }
  }
  EXPECT_GE(std::min(seen[0], seen[1]), 20);
}

// A motion and forces of which modes and doubles are said are found again. Where one mode is
// another, what is found is right all the same.
TEST(ExactWitness, FindsWhatIsPlanted) {
  RandomSource random(27);
  std::size_t found = 0;
  for (int round = 0; round < 400; ++round) {
    const bool in_space = random.one_in(2);
    Body body = planted(random, in_space);
    SCOPED_TRACE(body.file());
    const GraspLaw law = body.law();
    EXPECT_EQ(law.is_linear(), !in_space);
    const auto witness = exact_witness(law, body.near);
    EXPECT_TRUE(witness || !body.is_planted);
    if (witness) body.expect_accepted(Stable{*witness, witness->twist});
    found += witness ? 1 : 0;
    if (random.one_in(2)) body.near.normal[0] = body.near.normal[0] > 0 ? 0 : 1;
    if (random.one_in(2)) body.near.sticks[0] = body.near.sticks[0] == 0 ? 1 : 0;
    if (random.one_in(2)) body.near.friction[0][0] *= -1;
    const auto other = exact_witness(law, body.near);
    if (other) body.expect_accepted(Stable{*other, other->twist});
  }
  EXPECT_GE(found, 150U);
}

// A body turns about a pad at a wall; on a floor it has a foot at either side, the one a
// rounding above the other, or there under a ceiling. One of both slips by that, with all its
// friction, and the other takes what is left of the push: together as much as both can.
TEST(ExactWitness, OfTwoContactsOnOneFaceOneSlipsByARounding) {
  for (int k = 0; k < 6 * 21; ++k) {
    const int up = k % 2 == 0 ? 1 : -1;
    const Rational share(k / 6 - 10, up > 0 ? 10 : 11);
    const Rational half(1, 2);
    Body body;
    body.add({-1, 0}, {0, 1}, {half, 1, 1});
    body.add({1, Rational(k / 2 % 3 - 1, 1000000000)}, {0, up}, {half, 1, 1});
    body.add({0, 0}, {1, 0}, {half, 2, 1});
    const Rational other = 1 - Rational(up, 4);
    const Rational force = Rational(5, 4) + other;
    body.wrench = {share * half * force - 2, -Rational(5, 4) - up * other,
                   Rational(5, 4) - up * other};
    body.near = {Reals::Zero(3), {1.25, to_double(other), 2}, {}, {1, 1, 1}};
    body.near.motion[2] = 0.25;
    const GraspLaw law = body.law();
    law.scale(body.near.motion);
    const double part = to_double(share) / 2;
    body.near.friction = {{part * 1.25}, {up * part * to_double(other)}, {}};
    const auto witness = exact_witness(law, body.near);
    EXPECT_TRUE(witness) << body.file();
    if (witness) body.expect_accepted(Stable{*witness, witness->twist});
  }
}

}  // namespace
}  // namespace stickslip
