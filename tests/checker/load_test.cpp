// SPDX-License-Identifier: MIT
// The work of loads against loads one by one, and the words of a ball. All else about balls is
// for tests/rules, and words that are none for tests/check_py.
#include "load.hpp"

#include <gtest/gtest.h>

#include "arguments.hpp"
#include "support.hpp"

namespace stickslip_check {
namespace {

Rational fraction(Random& random, int most) {
  return Rational(between(random, -most * 4, most * 4)) / 4;
}

Vector fractions(Random& random, std::size_t size) {
  Vector v;
  for (std::size_t j = 0; j < size; ++j) v.push_back(fraction(random, 2));
  return v;
}

/// What a force and a torque at c do on a body that moves by u and turns by omega about 0.
Rational work_of(const Vector& z, const Vector& c, const Vector& motion) {
  if (c.size() == 2) {
    return z[0] * (motion[0] - motion[2] * c[1]) + z[1] * (motion[1] + motion[2] * c[0]) +
           z[2] * motion[2];
  }
  const Vector omega(motion.begin() + 3, motion.end());
  const Vector turned = cross(omega, c);
  Rational work;
  for (std::size_t j = 0; j < 3; ++j) {
    work += z[j] * (motion[j] + turned[j]) + z[j + 3] * omega[j];
  }
  return work;
}

TEST(Load, NoLoadOfABallDoesMoreWorkAndOneDoesNearlySo) {
  Random random(41);
  std::size_t inside = 0;
  std::size_t cut_shorter = 0;
  for (int trial = 0; trial < rounds(400); ++trial) {
    const std::size_t forces = trial % 2 == 0 ? 2 : 3;
    const std::size_t rows = forces == 2 ? 3 : 6;
    const auto dimension = static_cast<std::size_t>(between(random, 1, 8));
    Ball ball;
    ball.radius = Rational(between(random, 1, 8)) / 2;
    ball.length = Rational(between(random, 1, 9)) / 3;
    ball.about = fractions(random, forces);
    Matrix motion;
    for (std::size_t k = 0; k < rows; ++k) motion.push_back(fractions(random, dimension));
    const Vector w0 = fractions(random, dimension);
    const Load load(w0, ball, motion);
    const Vector y = fractions(random, dimension);
    Vector moved;  // J y
    for (const Vector& row : motion) moved.push_back(dot(row, y));
    const auto work = [&](const Vector& z) {
      return Rational(dot(w0, y) + work_of(z, ball.about, moved));
    };
    const auto is_inside = [&](const Vector& z) {
      Rational square;
      for (std::size_t j = 0; j < rows; ++j) {
        square += z[j] * z[j] / (j < forces ? Rational(1) : ball.length * ball.length);
      }
      return square <= ball.radius * ball.radius;
    };
    // Along what each number does alone.
    Vector best;  // multiples of the numbers that do most
    Rational square;
    for (std::size_t j = 0; j < rows; ++j) {
      Vector unit(rows);
      unit[j] = 1;
      const Rational length = j < forces ? Rational(1) : ball.length;
      const Rational along = work_of(unit, ball.about, moved) * length;
      best.emplace_back(along * length);
      square += along * along;
    }
    const Bounds bounds = load.work(y);
    if (square != 0) {
      const Rational scale = ball.radius / root_above(square);
      for (Rational& z : best) z *= scale;
      ASSERT_TRUE(is_inside(best));
      const Rational slack = bounds.high - work(best);
      EXPECT_GE(slack, 0);
      EXPECT_LE(slack, Rational(1, 1'000'000'000));
      Vector worst;
      for (const Rational& z : best) worst.emplace_back(-z);
      EXPECT_EQ(work(worst) - bounds.low, slack);
    } else {
      EXPECT_EQ(bounds, Bounds(dot(w0, y)));
    }
    // What a random cut leaves, of its two sides that which may do less work.
    const auto index = static_cast<std::size_t>(between(random, 0, static_cast<int>(rows) - 1));
    const Bounds& whole = load.numbers()[index];
    const Rational c = whole.high * between(random, -3, 3) / 4;
    const bool low = best[index] > 0;
    const Load part = load.with(index, low ? Bounds(whole.low, c) : Bounds(c, whole.high));
    const Bounds left = part.work(y);
    cut_shorter += left.high < bounds.high ? 1 : 0;
    for (int k = 0; k < 20; ++k) {
      Vector z;
      for (const Bounds& number : part.numbers()) {
        z.emplace_back(number.low + (number.high - number.low) * between(random, 0, 8) / 8);
      }
      if (!is_inside(z)) continue;
      ++inside;
      EXPECT_LE(work(z), left.high);
      EXPECT_GE(work(z), left.low);
    }
    // In the middle it is as near to 0 as it may be, and the others are 0.
    const Load middle = part.middle();
    ASSERT_TRUE(middle.certain());
    const Rational& z = middle.numbers()[index].low;
    EXPECT_EQ(z, low ? std::min(c, Rational(0)) : std::max(c, Rational(0)));
    Vector only(rows);
    only[index] = z;
    EXPECT_EQ(dot(middle.lowest(), y), work(only));
  }
  EXPECT_GT(inside, rounds(1000U));
  EXPECT_GT(cut_shorter, rounds(50U));
}

std::string problem_of(const std::string& tolerances) {
  try {
    parse_arguments({"grasp", "certificate", "--uncertain", tolerances});
  } catch (const UsageError& error) {
    return error.problem;
  }
  return "";
}

TEST(Load, WordsOfABall) {
  const Arguments arguments = parse_arguments(
      {"grasp", "certificate", "--uncertain",
       "friction=5%,wrench=ball:0.1:about=3:-1/2:1e1:length=2:body=a:length=b=3,position=1"});
  const auto& uncertain = arguments.options.uncertain;
  ASSERT_EQ(uncertain.size(), 3U);
  EXPECT_EQ(*uncertain.at("wrench").ball,
            (Ball{Rational(1, 10), 2, {3, Rational(-1, 2), 10}, "a:length=b=3"}));
  EXPECT_EQ(show(uncertain.at("wrench")),
            "ball:1/10:length=2:about=3:-1/2:10:body=a:length=b=3");
  EXPECT_EQ(problem_of("friction=ball:1"),
            "--uncertain: \"friction=ball:1\": only the wrench may have a ball");
  EXPECT_EQ(problem_of("wrench=ball:1:radius=2"),
            "--uncertain: \"ball:1:radius=2\" is not ball:R[:length=L][:about=X:Y[:Z]]"
            "[:body=NAME], such as ball:1/10:length=2");
}

}  // namespace
}  // namespace stickslip_check
