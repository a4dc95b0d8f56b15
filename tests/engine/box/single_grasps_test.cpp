// SPDX-License-Identifier: GPL-3.0-or-later
// Single grasps of a box: that they lie in it, where they should; and short numbers for them.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/box/box_prover.hpp"
#include "engine/box/examples.hpp"
#include "engine/box/short_numbers.hpp"
#include "engine/box/single_grasp.hpp"
#include "law_cases.hpp"
#include "stickslip/engine/branch_and_bound.hpp"

namespace stickslip {
namespace single_grasps_test {

using box_detail::Examples;
using box_detail::Place;
using test::RandomSource;

Place random_place(RandomSource& random, const Examples& examples) {
  Place place = examples.middle();
  for (Rational& entry : place) entry = Rational(random.between(-3, 3), 3);
  return place;
}

/// Returns the square of the slope by which the turned normal is off the other.
Rational squared_slope(const RationalRow& n, const RationalRow& turned) {
  const Rational along = dot(n, turned);
  return dot(turned, turned) * dot(n, n) / (along * along) - 1;
}

/// The grasps of `one` have their numbers in the intervals of `box`, and normals within slopes.
void expect_inside(const GraspBox& box, const GraspBox& one) {
  EXPECT_TRUE(one.is_point());
  ASSERT_EQ(one.contacts.size(), box.contacts.size());
  std::vector<Interval> intervals;
  for_each_number(box, [&](const Interval& interval) { intervals.push_back(interval); });
  std::size_t next = 0;
  std::size_t wrench = intervals.size() - box.wrench.size();
  for_each_number(one, [&](const Interval& number) {
    const bool is_of_ball = box.ball && next >= wrench;
    if (!is_of_ball) {
      EXPECT_TRUE(intervals[next].contains(number.low));
    }
    ++next;
  });
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const RationalRow& n = box.contacts[i].normal;
    const RationalRow& turned = one.contacts[i].normal;
    ASSERT_GT(dot(n, turned), 0);
    EXPECT_LE(squared_slope(n, turned), box.contacts[i].slope * box.contacts[i].slope);
  }
  if (!box.ball) return;
  RationalRow beside;
  for (std::size_t j = 0; j < box.wrench.size(); ++j) {
    beside.push_back(one.wrench[j].low - box.wrench[j].low);
  }
  EXPECT_LE(box.ball->squared_norm(beside), box.ball->radius * box.ball->radius);
}

TEST(Examples, LieInTheirBox) {
  RandomSource random(331);
  int turned = 0;
  for (int round = 0; round < 80; ++round) {
    const bool in_space = round % 2 == 1;
    GraspBox box = test::random_law_box(random, in_space);
    if (random.one_in(3)) {
      for (Interval& component : box.wrench) component = point_interval(component.low);
      box.ball = LoadBall{Rational(random.between(1, 9), 4), 2, {}, ""};
    }
    const Examples examples(box, NormalLaw::kUnilateral);
    const Place place = random_place(random, examples);
    const GraspBox one = examples.at(place);
    expect_inside(box, one);
    const auto again = examples.place_of(one);
    if (again) {
      EXPECT_EQ(*again, place);
    } else {
      bool is_turned = box.ball.has_value();
      for (std::size_t i = 0; i < box.contacts.size(); ++i) {
        is_turned = is_turned || one.contacts[i].normal != box.contacts[i].normal;
      }
      EXPECT_TRUE(is_turned);
      ++turned;
    }
    EXPECT_EQ(examples.extremes().size(), 2U);
    for (const Place& extreme : examples.extremes()) expect_inside(box, examples.at(extreme));
    for (const Place& end : examples.single_ends(12)) expect_inside(box, examples.at(end));
    if (!box.ball) continue;
    for (const Place& direction : examples.ball_directions()) {
      const GraspBox loaded = examples.at(direction);
      expect_inside(box, loaded);
      RationalRow beside;
      for (std::size_t j = 0; j < box.wrench.size(); ++j) {
        beside.push_back(loaded.wrench[j].low - box.wrench[j].low);
      }
      const double size = std::sqrt(to_double(box.ball->squared_norm(beside)));
      EXPECT_NEAR(size, to_double(box.ball->radius), 1e-5);
    }
    // The load that does the most work on a twist does no less than others of the ball.
    const RationalRow twist = test::random_row(random, box.wrench.size());
    const auto work = [&](const Place& at) {
      Rational sum = 0;
      const GraspBox loaded = examples.at(at);
      for (std::size_t j = 0; j < twist.size(); ++j) sum += twist[j] * loaded.wrench[j].low;
      return to_double(sum);
    };
    const double most = work(examples.loaded_along(twist, place));
    EXPECT_LE(work(place), most + 1e-4);
    for (const Place& direction : examples.ball_directions()) {
      EXPECT_LE(work(direction), most + 1e-4);
    }
  }
  EXPECT_GE(turned, 20);
}

// A normal in space that is turned all it may be, or farther, is turned by its slope, whichever
// way.
TEST(Examples, NormalsAreTurnedByAllOfTheirSlope) {
  RandomSource random(332);
  int turned = 0;
  for (int round = 0; round < 40; ++round) {
    const GraspBox box = test::random_law_box(random, true);
    const Examples examples(box, NormalLaw::kUnilateral);
    const double angle = random.between(0, 628) / 100.0;
    const double size = random.between(10, 14) / 10.0;
    Place place = examples.middle();
    const auto on_grid = [&](double part) {
      return rational_from_double(std::round(size * part * 65536) / 65536);
    };
    for (std::size_t k = 0; k < place.size(); ++k) {
      const Parameter parameter = examples.numbers()[k].parameter;
      if (parameter == Parameter::kTurnU) place[k] = on_grid(std::cos(angle));
      if (parameter == Parameter::kTurnV) place[k] = on_grid(std::sin(angle));
    }
    const GraspBox one = examples.at(place);
    for (std::size_t i = 0; i < box.contacts.size(); ++i) {
      if (box.contacts[i].slope.is_zero()) continue;
      const double slope = to_double(box.contacts[i].slope);
      const Rational squared = squared_slope(box.contacts[i].normal, one.contacts[i].normal);
      EXPECT_LE(squared, box.contacts[i].slope * box.contacts[i].slope);
      EXPECT_GE(std::sqrt(to_double(squared)), slope * (1 - 1e-4));
      ++turned;
    }
  }
  EXPECT_GE(turned, 20);
}

TEST(OneGrasp, PowersAndMiddlesAreShort) {
  RandomSource random(333);
  for (int round = 0; round < 200; ++round) {
    const Rational size(random.between(1, 999), random.between(1, 999));
    const Rational power = box_detail::power_of_two_above(size);
    EXPECT_GE(power, size);
    EXPECT_LT(power / 2, size);
    const Integer whole = power < 1 ? denominator(power) : numerator(power);
    EXPECT_EQ(numerator(power) * denominator(power), whole);
    EXPECT_EQ(whole, Integer(1) << static_cast<unsigned>(msb(whole)));
    const Rational low(random.between(-99, 99), random.between(1, 99));
    const Rational high = low + size;
    const Rational middle = box_detail::short_middle(low, high);
    EXPECT_LT(low, middle);
    EXPECT_LT(middle, high);
    EXPECT_LE(abs(Rational(middle - (low + high) / 2)), size / 16);
    EXPECT_EQ(denominator(middle), Integer(1)
                                       << static_cast<unsigned>(msb(denominator(middle))));
  }
  EXPECT_EQ(box_detail::power_of_two_above(0), 1);
  for (const Rational& power : {Rational(1, 8), Rational(1), Rational(16)}) {
    EXPECT_EQ(box_detail::power_of_two_above(power), power);
  }
}

// One grasp in the plane is the same problem by its law and by its contacts.
TEST(OneGrasp, ProblemsOfLawsAreThoseOfContacts) {
  RandomSource random(334);
  for (int round = 0; round < 40; ++round) {
    GraspBox box = test::random_law_box(random, false);
    for (UncertainContact& c : box.contacts) c.slope = 0;
    box = box.middle();
    const Problem expected(loaded_of(box), NormalLaw::kUnilateral);
    const Problem found = GraspLaw(box, NormalLaw::kUnilateral).problem().value();
    EXPECT_EQ(found.wrench(), expected.wrench());
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found.separation(ContactId(i)), expected.separation(ContactId(i)));
      EXPECT_EQ(found.slip_plane(ContactId(i)), expected.slip_plane(ContactId(i)));
      EXPECT_EQ(found.edge_wrench(ContactId(i), 1), expected.edge_wrench(ContactId(i), 1));
    }
    EXPECT_EQ(box_detail::is_stable(box, NormalLaw::kUnilateral),
              std::holds_alternative<Stable>(branch_and_bound(expected)));
  }
}

TEST(OneGrasp, TellsMotionsBeyondABound) {
  RandomSource random(335);
  GraspBox box = test::random_law_box(random, false);
  box.max_motion = {1, 2, 3};
  const GraspLaw law(box, NormalLaw::kUnilateral);
  for (std::size_t j = 0; j < 3; ++j) {
    for (const int sign : {1, -1}) {
      NearEquilibrium near{Reals::Zero(3), {}, {}, {}};
      const auto at = static_cast<Eigen::Index>(j);
      near.motion[at] = sign * 1.001 * to_double(box.max_motion[j]) * law.unit(j);
      EXPECT_TRUE(box_detail::is_beyond(law, near, box.max_motion));
      EXPECT_FALSE(box_detail::may_be_within(law, near));
      near.motion[at] *= 0.998;
      EXPECT_TRUE(box_detail::may_be_within(law, near));
      EXPECT_FALSE(box_detail::is_beyond(law, near, {}));
    }
  }
}

/// Pads of this friction press with 2 from both sides, and hold a weight between 1/4 and 3.
GraspBox pinch(const Interval& friction, const Interval& weight) {
  GraspBox box;
  for (const int side : {-1, 1}) {
    UncertainContact& c = box.contacts.emplace_back();
    c.position = {point_interval(side), point_interval(0)};
    c.normal = {-side, 0};
    c.friction = friction;
    c.preload = point_interval(2);
  }
  box.wrench = {{}, {-weight.high, -weight.low}, {}};
  return box;
}

// A single end has one number at an end, and all others in the middle.
TEST(Examples, SingleEndsMoveOneNumber) {
  const GraspBox box = pinch({Rational(1, 2), Rational(3, 5)}, {1, 2});
  const Examples examples(box, NormalLaw::kUnilateral);
  const std::vector<Place> ends = examples.single_ends(examples.numbers().size());
  EXPECT_EQ(ends.size(), 2 * examples.numbers().size());
  for (const Place& end : ends) {
    Rational moved = 0;
    for (const Rational& entry : end) moved += abs(entry);
    EXPECT_EQ(moved, 1);
  }
  EXPECT_TRUE(examples.single_ends(examples.numbers().size() - 1).empty());
}

// Friction mu of both pads carries 4 mu: a box is proved stable or not where that says so, and
// where it says both, suspects have the verdicts that they are said to have.
TEST(BoxProver, ProvesAPinchOrSuspectsParts) {
  const Rational half(1, 2);
  const Interval friction{half, Rational(3, 5)};
  const auto prove = [&](const Interval& weight, std::optional<std::size_t>& index) {
    SearchWork work;
    const GraspLaw law(pinch(friction, weight), NormalLaw::kUnilateral);
    BoxProver prover(law, {1000, 200, 5000, 8, true, false, true}, work);
    const auto verdict = prover.prove();
    index.reset();
    if (verdict) index = verdict->index();
    return prover.suspects();
  };
  std::optional<std::size_t> found;
  prove({Rational(7, 4), Rational(19, 10)}, found);
  EXPECT_EQ(found, 0U);
  prove({Rational(5, 2), Rational(13, 5)}, found);
  EXPECT_EQ(found, 1U);
  // The middle of this box holds, and that of the next one does not: so say the suspects.
  for (const std::size_t kind : {std::size_t{0}, std::size_t{1}}) {
    const Interval weight{Rational(3, 2), kind == 0 ? Rational(5, 2) : Rational(3)};
    const auto suspects = prove(weight, found);
    EXPECT_FALSE(found);
    ASSERT_TRUE(suspects[kind]);
    const GraspBox whole = pinch(friction, weight);
    const Examples examples(whole, NormalLaw::kUnilateral);
    for (std::size_t k = 0; k < 2; ++k) {
      if (!suspects[k]) continue;
      const GraspBox one = examples.between(*suspects[k]);
      expect_inside(whole, one);
      EXPECT_EQ(box_detail::is_stable(one, NormalLaw::kUnilateral), k == 0);
    }
  }
}

}  // namespace single_grasps_test
}  // namespace stickslip
