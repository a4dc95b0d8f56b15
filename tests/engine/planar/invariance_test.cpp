// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of a question that cannot change its answer. Each is applied to random grasps from
// all families; the evidence of every verdict is judged too.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "judged.hpp"
#include "rounds.hpp"

namespace stickslip {
namespace {

using test::judged_verdicts;
using test::RandomSource;

LoadedGrasp random_load(RandomSource& random, int round) {
  const auto m = static_cast<std::size_t>(random.between(1, 4));
  const Grasp grasp = round % 3 == 0 ? test::generic_grasp(random, m)
                      : round % 3 == 1
                          ? test::degenerate_grasp(random, m)
                          : test::near_degenerate_grasp(random, m, Rational(1, 1000000000));
  switch (random.between(0, 2)) {
    case 0:
      return {grasp, test::small_wrench(random)};
    case 1:
      return {grasp, test::planted_wrench(random, grasp, NormalLaw::kBilateral)};
    default:
      return {grasp, test::threshold_wrench(random, grasp, Rational(1, 1000000000))};
  }
}

using Change = std::function<LoadedGrasp(LoadedGrasp, RandomSource&)>;

void expect_invariant(std::uint64_t seed, const Change& change,
                      const std::function<LoadedGrasp(LoadedGrasp)>& prepare = {}) {
  RandomSource random(seed);
  int stable = 0;
  constexpr int kRounds = test::rounds(30);
  for (int round = 0; round < kRounds; ++round) {
    LoadedGrasp before = random_load(random, round);
    if (prepare) before = prepare(std::move(before));
    const LoadedGrasp after = change(before, random);
    const std::string verdict = judged_verdicts(before);
    EXPECT_EQ(judged_verdicts(after), verdict)
        << test::describe({before, {}}) << test::describe({after, {}});
    stable += verdict == "unstable" ? 0 : 1;
  }
  if (test::kSanitized) return;  // too few rounds to tell
  // Else nothing was tested.
  EXPECT_GE(stable, 5);
  EXPECT_LE(stable, kRounds - 5);
}

LoadedGrasp change_contacts(const LoadedGrasp& loaded,
                            const std::function<void(Contact&)>& change) {
  std::vector<Contact> contacts = loaded.grasp.contacts();
  for (Contact& c : contacts) change(c);
  return {Grasp(std::move(contacts)), loaded.wrench};
}

Rational positive(RandomSource& random) {
  return Rational(random.between(1, 7), random.between(1, 7));
}

/// (cos, sin) of the angle of a 3-4-5 triangle, or a quarter turn, either way.
Vector2 rational_turn(RandomSource& random) {
  const Rational c(3, 5);
  const Rational s(4, 5);
  return random.pick<Vector2>({{c, s}, {c, -s}, {-s, c}, {0, 1}, {-1, 0}, {s, -c}});
}

Vector2 times(const Vector2& z, const Vector2& v) {
  return {z.x * v.x - z.y * v.y, z.x * v.y + z.y * v.x};
}

TEST(Invariance, PermutationOfContacts) {
  expect_invariant(101, [](const LoadedGrasp& loaded, RandomSource& random) {
    std::vector<Contact> contacts = loaded.grasp.contacts();
    for (std::size_t i = contacts.size(); i > 1; --i) {
      const int other = random.between(0, static_cast<int>(i) - 1);
      std::swap(contacts[i - 1], contacts[static_cast<std::size_t>(other)]);
    }
    return LoadedGrasp{Grasp(std::move(contacts)), loaded.wrench};
  });
}

TEST(Invariance, LengthOfNormals) {
  expect_invariant(102, [](const LoadedGrasp& loaded, RandomSource& random) {
    return change_contacts(loaded, [&](Contact& c) {
      const Rational factor = positive(random);
      c.normal = {factor * c.normal.x, factor * c.normal.y};
    });
  });
}

LoadedGrasp in_units(const LoadedGrasp& loaded, const Rational& length, const Rational& force) {
  LoadedGrasp result = change_contacts(loaded, [&](Contact& c) {
    c.position = {length * c.position.x, length * c.position.y};
    c.preload *= force;
    c.stiffness *= force / length;
  });
  result.wrench = {force * loaded.wrench.x, force * loaded.wrench.y,
                   force * length * loaded.wrench.torque};
  return result;
}

TEST(Invariance, Units) {
  expect_invariant(103, [](const LoadedGrasp& loaded, RandomSource& random) {
    const Rational length = positive(random);
    return in_units(loaded, length, positive(random));
  });
}

/// So far from 1 that doubles of it, or of its products, overflow or vanish.
Rational enormous_or_tiny(RandomSource& random) {
  return parse_rational(random.pick<const char*>(
      {"1e-400", "1e-320", "1e-200", "1e-100", "1", "1e100", "1e200", "1e320", "1e400"}));
}

TEST(Invariance, EnormousAndTinyNumbers) {
  expect_invariant(109, [](const LoadedGrasp& loaded, RandomSource& random) {
    const Rational length = enormous_or_tiny(random);
    const Rational force = enormous_or_tiny(random);
    return change_contacts(in_units(loaded, length, force), [&](Contact& c) {
      const Rational normal = enormous_or_tiny(random);
      c.normal = {normal * c.normal.x, normal * c.normal.y};
    });
  });
}

TEST(Invariance, OneFactorOnAllStiffnesses) {
  expect_invariant(104, [](const LoadedGrasp& loaded, RandomSource& random) {
    const Rational factor = positive(random);
    return change_contacts(loaded, [&](Contact& c) { c.stiffness *= factor; });
  });
}

TEST(Invariance, OneFactorOnPreloadsAndWrench) {
  expect_invariant(105, [](const LoadedGrasp& loaded, RandomSource& random) {
    const Rational factor = positive(random);
    LoadedGrasp result = change_contacts(loaded, [&](Contact& c) { c.preload *= factor; });
    result.wrench = factor * loaded.wrench;
    return result;
  });
}

TEST(Invariance, RationalRigidMotion) {
  expect_invariant(106, [](const LoadedGrasp& loaded, RandomSource& random) {
    const Vector2 turn = rational_turn(random);
    const Vector2 shift{Rational(random.between(-9, 9), 2), Rational(random.between(-9, 9), 3)};
    LoadedGrasp result = change_contacts(loaded, [&](Contact& c) {
      c.position = times(turn, c.position);
      c.position.x += shift.x;
      c.position.y += shift.y;
      c.normal = times(turn, c.normal);
    });
    const Vector2 force = times(turn, {loaded.wrench.x, loaded.wrench.y});
    // The load now acts along a line through `shift`.
    result.wrench = {force.x, force.y,
                     loaded.wrench.torque + shift.x * force.y - shift.y * force.x};
    return result;
  });
}

TEST(Invariance, MirrorImage) {
  expect_invariant(107, [](const LoadedGrasp& loaded, RandomSource&) {
    LoadedGrasp result = change_contacts(loaded, [](Contact& c) {
      c.position.x = -c.position.x;
      c.normal.x = -c.normal.x;
    });
    result.wrench.x = -result.wrench.x;
    result.wrench.torque = -result.wrench.torque;
    return result;
  });
}

// Turning by 45 degrees while growing by sqrt(2) is multiplication by 1 + i: rational, though
// the normals become (1, 1), of irrational length. So non-unit normals without preload must
// behave as the unit normals that they stand for.
TEST(Invariance, IrrationalLengthsOfNormalsWithoutPreload) {
  const auto without_preload = [](const LoadedGrasp& loaded) {
    return LoadedGrasp{loaded.grasp.with_preload(0), loaded.wrench};
  };
  for (const Vector2& z : {Vector2{1, 1}, Vector2{2, 1}, Vector2{-1, 3}}) {
    expect_invariant(
        108,
        [&](const LoadedGrasp& loaded, RandomSource&) {
          LoadedGrasp result = change_contacts(loaded, [&](Contact& c) {
            c.position = times(z, c.position);
            c.normal = times(z, c.normal);
          });
          // Forces grow by |z| as well, torques by |z|^2.
          const Vector2 force = times(z, {loaded.wrench.x, loaded.wrench.y});
          result.wrench = {force.x, force.y, (z.x * z.x + z.y * z.y) * loaded.wrench.torque};
          return result;
        },
        without_preload);
  }
}

// Without friction only the line of action counts, although the circle of the contact changes.
TEST(Invariance, FrictionlessContactsMayMoveAlongTheirNormals) {
  expect_invariant(109, [](const LoadedGrasp& loaded, RandomSource& random) {
    return change_contacts(loaded, [&](Contact& c) {
      if (!c.friction.is_zero()) return;
      const Rational along(random.between(-6, 6), 2);
      c.position.x += along * c.normal.x;
      c.position.y += along * c.normal.y;
    });
  });
}

}  // namespace
}  // namespace stickslip
