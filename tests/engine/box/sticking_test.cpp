// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs by sticking: found at once for what sticks, and for nothing that does not hold.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/degree/newton.hpp"
#include "engine/degree/prove_stable.hpp"
#include "stickslip/engine/box_verdict.hpp"

namespace stickslip {
namespace {

constexpr NormalLaw kLaw = NormalLaw::kUnilateral;

using Vector = std::array<double, 3>;

/// Turns by two angles, in doubles with all their digits.
Vector turned(const Vector& v) {
  const double a = 0.7;
  const double b = 1.9;
  const Vector w{std::cos(a) * v[0] - std::sin(a) * v[1],
                 std::sin(a) * v[0] + std::cos(a) * v[1], v[2]};
  return {w[0], std::cos(b) * w[1] - std::sin(b) * w[2],
          std::sin(b) * w[1] + std::cos(b) * w[2]};
}

RationalRow exact(const Vector& v) {
  return {rational_from_double(v[0]), rational_from_double(v[1]), rational_from_double(v[2])};
}

/// Jaws of four contacts each, of this size, with preload 3 and friction 1/2, under `part` of
/// the force across them that is just held, 8 P / 2.
GraspBox jaws(double size, double part) {
  GraspBox box;
  for (const double side : {-1.0, 1.0}) {
    for (const double x : {-0.4, 0.4}) {
      for (const double y : {-0.3, 0.3}) {
        UncertainContact& c = box.contacts.emplace_back();
        for (const Rational& p : exact(turned({size * x, size * y, size * side}))) {
          c.position.push_back(point_interval(p));
        }
        c.normal = exact(turned({0, 0, -side}));
        c.friction = point_interval(Rational(1, 2));
        c.preload = point_interval(3);
      }
    }
  }
  const Vector force = turned({part * 12, 0, 0});
  for (const Rational& w : exact(force)) box.wrench.push_back(point_interval(w));
  for (int j = 0; j < 3; ++j) box.wrench.push_back(point_interval(0));
  return box;
}

std::optional<StickingProof> proof_of(const GraspBox& box) {
  const GraspLaw law(box, kLaw);
  const RoundedGrasp middle = rounded_middle(law.middle());
  for (const NearEquilibrium& near : Newton(middle).solve_from(1)) {
    if (auto proof = prove_sticking(law, near)) return proof;
  }
  return std::nullopt;
}

TEST(Sticking, IsProvedWithoutANodeInAnyUnit) {
  for (const double size : {1e-4, 0.03, 1.0, 1e4}) {
    const BoxDecision decision = decide_box(jaws(size, 0.9), kLaw);
    EXPECT_EQ(is_stable(decision.verdict), true) << size;
    EXPECT_EQ(decision.work.nodes, 0U) << size;
    EXPECT_TRUE(proof_of(jaws(size, 0.99))) << size;
  }
}

TEST(Sticking, ProvesNothingThatSlides) {
  for (const double part : {1.000001, 1.01, 2.0}) {
    EXPECT_FALSE(proof_of(jaws(1, part))) << part;
  }
}

TEST(Sticking, HoldsForABoxWhileFrictionHasToSpare) {
  GraspBox box = jaws(1, 0.8);
  Tolerances tolerances;
  tolerances.friction = Tolerance{Rational(1, 10), true};
  EXPECT_TRUE(proof_of(box.widened(tolerances)));
  tolerances.friction = Tolerance{Rational(3, 10), true};
  EXPECT_FALSE(proof_of(box.widened(tolerances)));
}

TEST(Sticking, StaysWithinABound) {
  GraspBox box = jaws(1, 0.5);
  for (const auto& [bound, is_proved] :
       {std::pair{Rational(1, 1000000), true}, std::pair{parse_rational("1e-30"), false}}) {
    box.max_motion = RationalRow(6, bound);
    EXPECT_EQ(proof_of(box).has_value(), is_proved) << bound;
  }
}

}  // namespace
}  // namespace stickslip
