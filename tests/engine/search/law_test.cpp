// SPDX-License-Identifier: GPL-3.0-or-later
// Laws against mechanics: rows of contacts against how a point of a body moves, separations
// against springs, and the work of loads against all corners of their box.
#include "stickslip/engine/law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "law_cases.hpp"
#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {
namespace law_test {

using test::NaivePlace;
using test::RandomSource;

/// A place for each choice of ends of what is uncertain of it, in the order of binary numbers.
std::vector<NaivePlace> naive_corners(const UncertainContact& c) {
  std::vector<Interval> numbers = c.position;
  const std::vector<Turn> turns = turns_of(c);
  for (const Turn& turn : turns) numbers.push_back({-turn.most, turn.most});
  std::size_t count = 1;
  for (const Interval& number : numbers) count *= number.low == number.high ? 1 : 2;
  std::vector<NaivePlace> corners;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t rest = k;
    RationalRow at;
    for (const Interval& number : numbers) {
      const bool is_wide = number.low != number.high;
      at.push_back(is_wide && rest % 2 == 1 ? number.high : number.low);
      if (is_wide) rest /= 2;
    }
    NaivePlace corner{{}, c.normal};
    for (std::size_t j = 0; j < c.position.size(); ++j) corner.position.push_back(at[j]);
    for (std::size_t t = 0; t < turns.size(); ++t) {
      for (std::size_t j = 0; j < c.normal.size(); ++j) {
        corner.normal[j] += at[c.position.size() + t] * turns[t].direction[j];
      }
    }
    corners.push_back(std::move(corner));
  }
  return corners;
}

// A force and its wrench are told by the work that they do on every motion.
TEST(Law, RowsAtCornersAreHowThePointOfContactMoves) {
  RandomSource random(71);
  for (int round = 0; round < 60; ++round) {
    const bool in_space = round % 2 == 1;
    const GraspBox box = test::random_law_box(random, in_space);
    const GraspLaw law(box, NormalLaw::kUnilateral);
    ASSERT_EQ(law.contacts.size(), box.contacts.size());
    for (std::size_t i = 0; i < box.contacts.size(); ++i) {
      const std::vector<NaivePlace> corners = naive_corners(box.contacts[i]);
      ASSERT_EQ(law.contacts[i].corners.size(), corners.size());
      const RationalRow d = test::random_row(random, law.motions);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const CornerRow& row = law.contacts[i].corners[k];
        EXPECT_EQ(dot(row.normal, d),
                  dot(corners[k].normal, test::moved(corners[k].position, d)));
        const RationalRow slip = test::naive_slip(corners[k], box.contacts[i].normal, d);
        ASSERT_EQ(row.slip.size(), slip.size());
        for (std::size_t j = 0; j < slip.size(); ++j) {
          const RationalRow function(row.slip[j].begin(), row.slip[j].end());
          EXPECT_EQ(dot(function, d), row.slip_factor * slip[j]);
        }
        const RationalRow force = test::random_row(random, slip.size());
        EXPECT_EQ(dot(row.wrench_of(force), d), dot(force, slip));
      }
    }
  }
}

/// A function of points (d, h) as its values at D + 1 unit points.
using Function = RationalRow;

// The separations of a contact are those of its spring at all corners of what is uncertain of
// it. Turned normals are longer, which the ends of preload and stiffness allow for.
TEST(Law, SeparationsAreThoseOfSprings) {
  RandomSource random(72);
  for (int round = 0; round < 60; ++round) {
    const bool in_space = round % 2 == 1;
    GraspBox box = test::random_law_box(random, in_space);
    UncertainContact& c = box.contacts.front();
    const test::Direction n = test::random_direction(random, in_space);
    c.normal = n.normal;
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const LawContact& contact = law.contacts.front();
    if (c.slope.is_zero()) {
      EXPECT_EQ(contact.preload.low, c.preload.low / n.length);
      EXPECT_EQ(contact.preload.high, c.preload.high / n.length);
      EXPECT_EQ(contact.stiffness.low, c.stiffness.low / (n.length * n.length));
      EXPECT_EQ(contact.stiffness.high, c.stiffness.high / (n.length * n.length));
    }
    // (A normal at a corner in space is outside of the cone that the slope says.)
    for (const Rational& slope : {Rational(0), c.slope}) {
      const Rational square = n.length * n.length * (1 + slope * slope);
      EXPECT_LE(contact.preload.low * contact.preload.low * square,
                c.preload.low * c.preload.low);
      EXPECT_GE(contact.preload.high * contact.preload.high * square,
                c.preload.high * c.preload.high);
      EXPECT_LE(contact.stiffness.low * square, c.stiffness.low);
      EXPECT_GE(contact.stiffness.high * square, c.stiffness.high);
    }
    std::vector<Function> expected;
    for (const NaivePlace& corner : naive_corners(c)) {
      for (const Rational& p : ends_of(contact.preload)) {
        for (const Rational& k : ends_of(contact.stiffness)) {
          Function function;
          for (std::size_t j = 0; j < law.motions; ++j) {
            RationalRow unit(law.motions);
            unit[j] = 1;
            function.push_back(-k * dot(corner.normal, test::moved(corner.position, unit)));
          }
          function.push_back(p);
          function.emplace_back(0);
          expected.push_back(std::move(function));
        }
      }
    }
    std::vector<Function> found;
    for (std::size_t k = 0; k < contact.separations.size(); ++k) {
      Function& function = found.emplace_back();
      for (const Integer& entry : contact.separations[k]) {
        function.push_back(contact.separation_factors[k] * Rational(entry));
      }
    }
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    EXPECT_EQ(contact.has_certain_separation, expected.size() == 1);
  }
}

// 1/|n| is between two numbers of so many bits, whatever |n| is.
TEST(Law, IrrationalLengthsAreEnclosed) {
  for (const unsigned bits : {20U, 64U, 200U}) {
    GraspBox box;
    UncertainContact& c = box.contacts.emplace_back();
    c.position = {point_interval(0), point_interval(1)};
    c.normal = {1, 2};
    c.friction = point_interval(0);
    c.preload = point_interval(3);
    box.wrench = {{}, {}, {}};
    const GraspLaw law(box, NormalLaw::kUnilateral, bits);
    const Interval& preload = law.contacts.front().preload;
    EXPECT_LT(preload.low * preload.low * 5, 9);
    EXPECT_GT(preload.high * preload.high * 5, 9);
    Rational width = 1;
    for (unsigned k = 0; k + 8 < bits; ++k) width /= 2;
    EXPECT_LT(preload.high - preload.low, width);
  }
}

/// The least and the largest work of a load of the box, by all of its corners.
Rational most_work(const WrenchBox& wrench, const Row& y) {
  std::vector<Rational> works{0};
  for (std::size_t j = 0; j < wrench.size(); ++j) {
    std::vector<Rational> more;
    for (const Rational& end : {wrench[j].low, wrench[j].high}) {
      for (const Rational& work : works) more.push_back(work + end * Rational(y[j]));
    }
    works = std::move(more);
  }
  return *std::max_element(works.begin(), works.end());
}

TEST(Law, TheMostWorkOfALoadIsThatOfACorner) {
  RandomSource random(73);
  for (int round = 0; round < 60; ++round) {
    const GraspLaw law(test::random_law_box(random, round % 2 == 1), NormalLaw::kUnilateral);
    for (int k = 0; k < 4; ++k) {
      Row y(law.motions);
      for (Integer& entry : y) entry = random.between(-3, 3);
      EXPECT_EQ(law.most_load_work(y), most_work(law.wrench, y));
    }
  }
}

// The most work of a ball of loads is that of the load in its middle and of the radius times
// |y|, up to a bound of the root.
TEST(Law, TheMostWorkOfABallIsItsRadiusTimesTheTwist) {
  RandomSource random(74);
  for (int round = 0; round < 60; ++round) {
    const bool in_space = round % 2 == 1;
    GraspBox box = test::random_law_box(random, in_space);
    for (Interval& component : box.wrench) component = point_interval(component.low);
    const Rational length(random.between(1, 6), 2);
    box.ball = LoadBall{Rational(random.between(1, 9), 4), length, {}, ""};
    const GraspLaw law(box, NormalLaw::kUnilateral);
    Row y(law.motions);
    for (Integer& entry : y) entry = random.between(-3, 3);
    Rational square = 0;
    for (std::size_t j = 0; j < y.size(); ++j) {
      const Rational across = Rational(y[j]) * (law.rotates[j] != 0 ? length : Rational(1));
      square += across * across;
    }
    const Rational beyond = law.most_load_work(y) - most_work(box.wrench, y);
    const double exact = to_double(box.ball->radius) * std::sqrt(to_double(square));
    EXPECT_GE(beyond * beyond, box.ball->radius * box.ball->radius * square);
    EXPECT_NEAR(to_double(beyond), exact, 1e-3 * exact);
  }
}

// Doubles propose from the same rows, in units in which the largest arm is 1.
TEST(Law, DoublesAreTheSameRowsInUnitsOfLength) {
  RandomSource random(75);
  for (int round = 0; round < 60; ++round) {
    const GraspLaw law(test::random_law_box(random, round % 2 == 1), NormalLaw::kUnilateral);
    for (const LawContact& c : law.contacts) {
      for (const CornerRow& row : c.corners) {
        for (std::size_t j = 0; j < law.motions; ++j) {
          const auto at = static_cast<Eigen::Index>(j);
          const double unit = law.rotates[j] != 0 ? law.length : 1;
          EXPECT_NEAR(row.normal_rounded[at] * unit, to_double(row.normal[j]), 1e-12);
        }
      }
      const double size = std::sqrt(to_double(c.squared_length));
      EXPECT_NEAR(c.slopes[0], to_double(c.friction.low) * size, 1e-12);
      EXPECT_NEAR(c.slopes[1], to_double(c.friction.high) * size, 1e-12);
      EXPECT_NEAR(c.preloads[1], to_double(c.preload.high), 1e-12);
      EXPECT_NEAR(c.stiffnesses[0], to_double(c.stiffness.low), 1e-12);
    }
  }
}

}  // namespace law_test
}  // namespace stickslip
