// SPDX-License-Identifier: MIT
// What doubles settle against exact signs, and what is rounded. That trees are judged rightly
// is for tests/rules and the twins of tests/certificate/python.
#include "tree.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "leaf.hpp"
#include "question.hpp"
#include "support.hpp"

namespace stickslip_check {
namespace {

constexpr std::size_t kN = kPlanar + 2;

/// A small random contact: degenerate cases are frequent.
Contact random_contact(Random& random) {
  Contact contact;
  contact.position = {Rational(between(random, -2, 2)), Rational(between(random, -2, 2))};
  constexpr int kNormals[][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {3, 4}, {-4, 3}, {2, 0}};
  const int* n = kNormals[between(random, 0, 6)];
  contact.normal = {Rational(n[0]), Rational(n[1])};
  contact.friction = Rational(between(random, 0, 3), 2);
  contact.stiffness = between(random, 1, 2);
  contact.preload = between(random, 0, 2);
  return contact;
}

Question random_question(Random& random, int max_contacts) {
  Grasp grasp{{}, Wrench(3)};
  Options options;
  const int m = between(random, 0, max_contacts);
  for (int i = 0; i < m; ++i) grasp.contacts.push_back(random_contact(random));
  for (Bounds& c : grasp.wrench) c = between(random, -3, 3);
  if (between(random, 0, 1) == 0) return pose(grasp, options, "");
  // A family.
  options.wrench.emplace();
  for (const Bounds& c : grasp.wrench) options.wrench->push_back(c.low);
  options.direction = Vector{1, between(random, -2, 2), between(random, -2, 2)};
  if (between(random, 0, 1) == 0) {
    options.preload_direction.emplace();
    options.preload_direction->scale = between(random, 0, 2) == 0;
    for (int i = 0; i < m; ++i) {
      options.preload_direction->values.emplace_back(between(random, 0, 2));
    }
  }
  return pose(grasp, options, "");
}

Vector random_twist(Random& random) {
  Vector y;
  for (std::size_t j = 0; j < kPlanar; ++j) y.emplace_back(between(random, -2, 2));
  return between(random, 0, 4) == 0 ? Vector(kPlanar) : y;
}

// What a region inherits is what a look at all contacts gives, and what doubles prove is so.
TEST(Tree, WhatIsSettledIsInherited) {
  Random random(1618);
  std::size_t settled_above = 0;
  std::size_t visited = 0;
  std::size_t holding = 0;
  std::size_t proved = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const Question question = random_question(random, 6);
    const Box& box = *question.box;
    const auto doubles = make_doubles(box);
    ASSERT_NE(doubles, nullptr);
    const Settled nothing(box, doubles);
    Settled inherited = nothing;
    Cone cone(kN);
    Set strict;
    insert(strict, 0);
    cone = cone.cut(make_form({0, 0, 0, 1, 0})).cut(make_form({0, 0, 0, 0, 1}), true);
    for (int cuts = between(random, 0, 8); cuts >= 0; --cuts) {
      const Generators region(box, cone, {strict, {}});
      if (region.barred()) break;
      settled_above += box.size() - inherited.unsettled().size();
      visited += inherited.unsettled().size();
      inherited = inherited.within(region);
      const Settled directly = nothing.within(region);
      // Where v = 0, a contact that was closed above still is, and counts as open otherwise.
      std::vector<Unsettled> both;
      for (const Unsettled& contact : inherited.unsettled()) {
        bool idle = true;
        for (const Generator& generator : region) {
          idle = idle && sign_of_dot(box.row(contact.contact).v[0], *generator.x) == 0;
        }
        if (!idle) both.push_back(contact);
      }
      ASSERT_EQ(both, directly.unsettled()) << "trial " << trial;
      for (int leaves = 0; leaves < 3; ++leaves) {
        const Vector y = random_twist(random);
        const bool holds = !leaf_refusal(box, region, y);
        holding += holds ? 1 : 0;
        for (const Settled& settled : {inherited, directly}) {
          const bool is_proved = settled.proves(region, y);
          proved += is_proved ? 1 : 0;
          EXPECT_TRUE(holds || !is_proved) << "trial " << trial;
        }
      }
      Form a(kN);
      for (Integer& c : a) c = between(random, -1, 1);
      if (box.size() > 0) {
        const Row& row = box.row(
            static_cast<std::size_t>(between(random, 0, static_cast<int>(box.size()) - 1)));
        const int which = between(random, 0, 4);
        if (which < 2) a = row.tau[0];
        if (which >= 2 && which < 4) a = row.v[0];
      }
      if (between(random, 0, 2) == 0) a = negative(a);
      if (between(random, 0, 1) == 0) insert(strict, cone.cuts());
      cone = cone.cut(a);
    }
  }
  EXPECT_GT(settled_above, visited / 16);
  EXPECT_GT(holding, 500U);
  // Those at a tie are left: here nearly all that hold are without a load.
  EXPECT_GT(proved, holding / 2);
}

/// What a region settles, by exact signs alone.
std::vector<Unsettled> unsettled_exactly(const Box& box, const Generators& region) {
  std::vector<Unsettled> all;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Row& row = box.row(i);
    bool has[2][3]{};  // of v and tau: whether it is somewhere below 0, 0, above 0
    Barring sticks(region);
    for (const Generator& generator : region) {
      const int slip = sign_of_dot(row.tau[0], *generator.x);
      has[0][sign_of_dot(row.v[0], *generator.x) + 1] = true;
      has[1][slip + 1] = true;
      if (slip == 0) sticks.add(generator);
    }
    if (!has[0][2]) continue;
    const bool closed = !has[0][0];
    int slip = has[1][2] == has[1][0] || !sticks.barred() ? 0 : has[1][2] ? 1 : -1;
    if (row.edges[0] == row.edges[3]) slip = 1;
    if (closed && slip != 0) continue;
    all.push_back({static_cast<std::uint32_t>(i), closed, static_cast<std::int8_t>(slip)});
  }
  return all;
}

// Signs that doubles give are the exact ones: of numbers far apart, of sums that cancel to 0 or
// to next to nothing, and of numbers that doubles do not hold.
TEST(Tree, DoublesSettleWhatExactSignsDo) {
  Random random(1729);
  const auto power = [](int exponent) {
    const Integer size = Integer(1) << static_cast<unsigned>(std::abs(exponent));
    return exponent < 0 ? Rational(1, size) : Rational(size);
  };
  // Mostly small, some a little off, some huge or tiny.
  const auto number = [&](int most) {
    Rational x = between(random, -3, 3);
    if (between(random, 0, 3) == 0) x += power(between(random, -70, -40));
    if (between(random, 0, 3) == 0) x *= power(between(random, -most, most));
    return x;
  };
  std::size_t with_doubles = 0;
  std::size_t settled = 0;
  std::size_t holding = 0;
  std::size_t proved = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const int most = between(random, 0, 4) == 0 ? 250 : 40;
    Grasp grasp{{}, Wrench(3)};
    for (Bounds& w : grasp.wrench) w = number(most);
    for (int k = between(random, 1, 5); k > 0; --k) {
      Contact contact{{number(most), number(most)}, {number(most), number(most)}, 0, 1, 0};
      if (contact.normal == Vector(2)) contact.normal = {3, 4};
      contact.friction = Rational(abs(number(most)));
      contact.stiffness = Rational(abs(number(most)) + power(-most));
      if (between(random, 0, 1) == 0 && exact_sqrt(dot(contact.normal, contact.normal))) {
        contact.preload = Rational(abs(number(most)));
      }
      grasp.contacts.push_back(contact);
    }
    const Question question = pose(grasp, {}, "");
    const Box& box = *question.box;
    const auto doubles = make_doubles(box);
    if (!doubles) continue;
    ++with_doubles;
    const Settled nothing(box, doubles);
    Cone cone(kN);
    Set strict;
    insert(strict, 0);
    cone = cone.cut(make_form({0, 0, 0, 1, 0})).cut(make_form({0, 0, 0, 0, 1}), true);
    for (int cuts = between(random, 0, 6); cuts >= 0; --cuts) {
      const Generators region(box, cone, {strict, {}});
      if (region.barred()) break;
      const Settled inside = nothing.within(region);
      const auto exactly = unsettled_exactly(box, region);
      ASSERT_EQ(inside.unsettled(), exactly) << "trial " << trial;
      settled += box.size() - exactly.size();
      for (int leaves = 0; leaves < 3; ++leaves) {
        const Vector y{number(most), number(most), number(most)};
        const bool holds = !leaf_refusal(box, region, y);
        const bool is_proved = inside.proves(region, y);
        holding += holds ? 1 : 0;
        proved += is_proved ? 1 : 0;
        ASSERT_TRUE(holds || !is_proved) << "trial " << trial;
      }
      const Row& row = box.row(
          static_cast<std::size_t>(between(random, 0, static_cast<int>(box.size()) - 1)));
      Form a = between(random, 0, 1) == 0 ? row.v[0] : row.tau[0];
      const int which = between(random, 0, 3);
      if (which == 0)
        a = make_form({number(most), number(most), number(most), number(most), 0});
      if (which == 1) a = negative(a);
      if (between(random, 0, 1) == 0) insert(strict, cone.cuts());
      cone = cone.cut(a);
    }
  }
  EXPECT_GT(with_doubles, 1000U);
  EXPECT_GT(settled, 1000U);
  EXPECT_GT(holding, 100U);
  EXPECT_GT(proved, holding / 4);
}

// Numbers that are out of all proportion leave everything to exact arithmetic.
TEST(Tree, DoublesOfVeryDifferentSizeAreNotTaken) {
  const auto doubles_of = [](const Contact& contact, const Rational& push) {
    return make_doubles(*pose({{contact}, {0, push, 0}}, {}, "").box);
  };
  Rational tiny(1, Integer(1) << 200U);
  EXPECT_NE(doubles_of({{0, 0}, {0, 1}, 0, 1, 0}, -1), nullptr);
  EXPECT_EQ(doubles_of({{0, 0}, {0, 1}, 0, tiny, 0}, -1), nullptr);
  EXPECT_EQ(doubles_of({{0, 0}, {0, 1}, tiny, 1, 0}, -1), nullptr);
  EXPECT_EQ(doubles_of({{0, 0}, {0, 1}, 0, 1, tiny}, -1), nullptr);
  EXPECT_EQ(doubles_of({{0, 0}, {0, 1}, 0, 1, 0}, tiny), nullptr);
}

// Weights of long denominators: what is rounded up must not decide where it is too much.
TEST(Tree, RoundingUpDecidesNothing) {
  // One contact below the body, pushed by -k e: v = -k y_d, in balance with y_d = -1 exactly.
  Rational k;
  mpz_ui_pow_ui(k.get_num_mpz_t(), 3, 200);
  mpz_ui_pow_ui(k.get_den_mpz_t(), 7, 150);
  const Contact contact{{0, 0}, {0, 1}, 0, k, 0};
  // On d_y <= -h the contact pushes by k or more: (0, -1, 0) refutes a push by anything less.
  for (const int much : {0, 1}) {
    Rational push = k;
    if (much == 0) push -= Rational(1, Integer(1) << 400U);
    const Question question = pose({{contact}, {0, Rational(-push), 0}}, {}, "");
    TreeWalk walk(roots_of(question, {{0, 0}}));
    walk.visit({NodeKind::kPlane, 0, {0, -1, 0, -1, 0}});
    const Node leaf{NodeKind::kLeaf, 0, {0, -1, 0}};
    if (much == 0) {
      EXPECT_NO_THROW(walk.visit(leaf));
    } else {
      EXPECT_THROW(walk.visit(leaf), Rejected);
    }
  }
}

}  // namespace
}  // namespace stickslip_check
