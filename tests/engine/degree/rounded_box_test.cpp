// SPDX-License-Identifier: GPL-3.0-or-later
// Grasps of a box in doubles, against mechanics at the same place; and the forces that answer a
// wrench over a box, against all its corners.
#include "engine/degree/rounded_box.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/degree/answering_forces.hpp"
#include "law_cases.hpp"

namespace stickslip {
namespace rounded_box_test {

using test::NaivePlace;
using test::RandomSource;

constexpr double kNearly = 1e-9;

/// The number at this part of the way, from -1 to 1.
Rational at(const Interval& interval, const Rational& place) {
  return interval.middle() + place * (interval.high - interval.low) / 2;
}

struct Chosen {
  std::vector<Rational> exact;  ///< by uncertain number
  RoundedBox::Place place;
};

Chosen random_place(RandomSource& random, const RoundedBox& box) {
  Chosen chosen{{}, RoundedBox::Place(static_cast<Eigen::Index>(box.numbers().size()))};
  for (Eigen::Index k = 0; k < chosen.place.size(); ++k) {
    chosen.exact.emplace_back(random.between(-4, 4), 4);
    chosen.place[k] = to_double(chosen.exact.back());
  }
  return chosen;
}

/// The place of a parameter: that of the number, or any if the parameter is certain.
Rational place_of(const RoundedBox& box, const Chosen& chosen, Parameter parameter,
                  std::size_t index) {
  for (std::size_t k = 0; k < box.numbers().size(); ++k) {
    const ParameterId& id = box.numbers()[k];
    if (id.parameter == parameter && id.index == index) return chosen.exact[k];
  }
  return 0;
}

// Rows do on every motion what the point of contact does, with its numbers at this place;
// friction, springs and the load are what lies there in their intervals.
TEST(RoundedBox, GraspsAreThoseAtTheirPlace) {
  RandomSource random(311);
  int uncertain = 0;
  for (int round = 0; round < 120; ++round) {
    const bool in_space = round % 2 == 1;
    const GraspBox box = test::random_law_box(random, in_space);
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const RoundedBox rounded(law);
    uncertain += static_cast<int>(rounded.numbers().size());
    const Chosen chosen = random_place(random, rounded);
    const RoundedGrasp grasp = rounded.at(chosen.place);
    ASSERT_EQ(grasp.contacts.size(), box.contacts.size());
    const RationalRow d = test::random_row(random, law.motions);
    Reals motion(static_cast<Eigen::Index>(law.motions));
    for (std::size_t j = 0; j < d.size(); ++j) {
      motion[static_cast<Eigen::Index>(j)] = to_double(d[j]) * law.unit(j);
      EXPECT_EQ(grasp.unit(j), law.unit(j));
      const Rational load = at(box.wrench[j], place_of(rounded, chosen, Parameter::kWrench, j));
      EXPECT_NEAR(grasp.load[static_cast<Eigen::Index>(j)] * law.unit(j), to_double(load),
                  kNearly);
    }
    for (std::size_t i = 0; i < box.contacts.size(); ++i) {
      const UncertainContact& c = box.contacts[i];
      const LawContact& of_law = law.contacts[i];
      const auto here = [&](Parameter parameter, const Interval& interval) {
        return at(interval, place_of(rounded, chosen, parameter, i));
      };
      NaivePlace place{{}, c.normal};
      constexpr Parameter kPosition[] = {Parameter::kX, Parameter::kY, Parameter::kZ};
      for (std::size_t j = 0; j < c.position.size(); ++j) {
        place.position.push_back(here(kPosition[j], c.position[j]));
      }
      const std::vector<Turn> turns = turns_of(c);
      for (std::size_t t = 0; t < turns.size(); ++t) {
        const Parameter parameter = !in_space ? Parameter::kTurn
                                    : t == 0  ? Parameter::kTurnU
                                              : Parameter::kTurnV;
        const Rational e = here(parameter, {-turns[t].most, turns[t].most});
        for (std::size_t j = 0; j < c.normal.size(); ++j) {
          place.normal[j] += e * turns[t].direction[j];
        }
      }
      const RoundedContact& found = grasp.contacts[i];
      const Rational rise = dot(place.normal, test::moved(place.position, d));
      EXPECT_NEAR(found.normal.dot(motion), to_double(rise), 1e-7);
      const RationalRow slip = test::naive_slip(place, c.normal, d);
      const Eigen::VectorXd seen = found.slip * motion;
      for (std::size_t k = 0; k < of_law.directions.size(); ++k) {
        const double along =
            to_double(dot(of_law.directions[k], slip)) /
            std::sqrt(to_double(dot(of_law.directions[k], of_law.directions[k])));
        EXPECT_NEAR(seen[static_cast<Eigen::Index>(k)], along, 1e-7);
      }
      // (In the plane T has the length of n.)
      const double length = in_space ? std::sqrt(to_double(dot(c.normal, c.normal))) : 1;
      EXPECT_NEAR(found.slope, to_double(here(Parameter::kFriction, c.friction)) * length,
                  kNearly);
      EXPECT_NEAR(found.preload, to_double(here(Parameter::kPreload, of_law.preload)), kNearly);
      EXPECT_NEAR(found.stiffness, to_double(here(Parameter::kStiffness, of_law.stiffness)),
                  kNearly);
      const double v = found.preload - found.stiffness * to_double(rise);
      EXPECT_NEAR(found.separation(motion), v, 1e-7);
      EXPECT_NEAR(found.force(motion), std::max(v, 0.0), 1e-7);
    }
  }
  EXPECT_GE(uncertain, 400);
}

void expect_same(const RoundedGrasp& one, const RoundedGrasp& other) {
  EXPECT_NEAR((one.load - other.load).norm(), 0, kNearly);
  ASSERT_EQ(one.contacts.size(), other.contacts.size());
  for (std::size_t i = 0; i < one.contacts.size(); ++i) {
    const RoundedContact& a = one.contacts[i];
    const RoundedContact& b = other.contacts[i];
    EXPECT_NEAR((a.normal - b.normal).norm() + (a.slip - b.slip).norm(), 0, kNearly);
    EXPECT_NEAR(a.slope, b.slope, kNearly);
    EXPECT_NEAR(a.preload, b.preload, kNearly);
    EXPECT_NEAR(a.stiffness, b.stiffness, kNearly);
    EXPECT_NEAR(a.size, b.size, kNearly);
  }
}

TEST(RoundedBox, TheMiddleIsTheSameBothWays) {
  RandomSource random(312);
  for (int round = 0; round < 40; ++round) {
    const GraspLaw law(test::random_law_box(random, round % 2 == 1), NormalLaw::kUnilateral);
    const RoundedBox rounded(law);
    expect_same(rounded.at(rounded.middle()), rounded_middle(law));
  }
}

// One grasp in the plane is the same by its problem and by its law, but for the unit of length.
TEST(RoundedBox, ProblemsAreRoundedAsLawsAre) {
  RandomSource random(313);
  for (int round = 0; round < 40; ++round) {
    const LoadedGrasp loaded{test::generic_grasp(random, 3), test::small_wrench(random)};
    const Problem problem(loaded, NormalLaw::kUnilateral);
    const Law law = planar_law(problem);
    RoundedGrasp one = rounded_grasp(problem);
    RoundedGrasp other = rounded_middle(law);
    for (RoundedGrasp* grasp : {&one, &other}) {
      EXPECT_GT(grasp->length, 0);
      EXPECT_GT(grasp->force, 0);
      EXPECT_GT(grasp->reach, 0);
      grasp->load[2] *= grasp->length;
      for (RoundedContact& c : grasp->contacts) {
        c.normal[2] *= grasp->length;
        c.slip(0, 2) *= grasp->length;
      }
    }
    expect_same(one, other);
  }
}

// The farthest place has the ends of all numbers, and each normal turned by its slope one way;
// of a ball it has the load that is farthest.
TEST(RoundedBox, NoPlaceIsFarther) {
  RandomSource random(314);
  int turned = 0;
  for (int round = 0; round < 60; ++round) {
    GraspBox box = test::random_law_box(random, round % 2 == 1);
    const bool has_ball = round % 4 > 1;
    if (has_ball) {
      for (Interval& component : box.wrench) component = point_interval(component.low);
      box.ball =
          LoadBall{Rational(random.between(1, 9), 4), Rational(random.between(1, 3)), {}, ""};
    }
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const RoundedBox rounded(law);
    Eigen::VectorXd function(static_cast<Eigen::Index>(rounded.numbers().size()));
    for (double& entry : function) entry = random.between(-3, 3);
    const RoundedBox::Place far = rounded.farthest(function);
    EXPECT_LE(far.lpNorm<Eigen::Infinity>(), 1 + kNearly);
    double others = 0;
    double squared = 0;
    for (Eigen::Index k = 0; k < function.size(); ++k) {
      const Parameter parameter = rounded.numbers()[static_cast<std::size_t>(k)].parameter;
      if (has_ball && parameter == Parameter::kWrench) {
        squared += function[k] * function[k];
      } else if (parameter == Parameter::kTurnU) {
        others += std::hypot(function[k], function[k + 1]);
        EXPECT_LE(std::hypot(far[k], far[k + 1]), 1 + kNearly);
        ++turned;
      } else if (parameter != Parameter::kTurnV) {
        others += std::fabs(function[k]);
      }
    }
    // In units of their halves the loads of a ball are a ball of radius 1.
    EXPECT_NEAR(function.dot(far), others + std::sqrt(squared), 1e-6);
    if (!has_ball) continue;
    const Reals beside = rounded.load_at(far) - rounded.load_at(rounded.middle());
    double size = 0;
    for (std::size_t j = 0; j < law.motions; ++j) {
      const double component = beside[static_cast<Eigen::Index>(j)] * law.unit(j);
      const double unit = law.rotates[j] != 0 ? to_double(box.ball->length) : 1;
      size += component * component / (unit * unit);
    }
    EXPECT_LE(std::sqrt(size), to_double(box.ball->radius) * (1 + 1e-6));
  }
  EXPECT_GE(turned, 20);
}

// The ends of forces and loads over a box are those of its corners.
TEST(AnsweringForces, EndsAreThoseOfCorners) {
  RandomSource random(315);
  for (int round = 0; round < 60; ++round) {
    const GraspBox box = test::random_law_box(random, round % 2 == 1);
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const LawContact& c = law.contacts.front();
    const RationalRow friction = test::random_row(random, c.slip_numbers());
    const std::vector<Rational> normals{random.between(-2, 2), random.between(-2, 2)};
    degree_detail::WrenchRange sum(law.motions, {-1, 2});
    degree_detail::add_wrenches(sum, c, friction, normals);
    for (std::size_t j = 0; j < law.motions; ++j) {
      std::vector<Rational> entries;
      for (const CornerRow& corner : c.corners) {
        for (const Rational& a : normals) {
          entries.push_back(a * corner.normal[j] + corner.wrench_of(friction)[j]);
        }
      }
      EXPECT_EQ(sum[j].low, *std::min_element(entries.begin(), entries.end()) - 1);
      EXPECT_EQ(sum[j].high, *std::max_element(entries.begin(), entries.end()) + 2);
      EXPECT_EQ(degree_detail::largest(sum[j]),
                std::max<Rational>(abs(sum[j].low), abs(sum[j].high)));
    }
    const degree_detail::WrenchRange loads = degree_detail::loads_at(law, 0);
    for (std::size_t j = 0; j < law.motions; ++j) {
      EXPECT_EQ(loads[j].low, box.wrench[j].low);
      EXPECT_EQ(loads[j].high, box.wrench[j].high);
    }
    const Rational length = degree_detail::length_above(c, friction);
    EXPECT_GE(length * length, c.squared_force(friction));
    EXPECT_NEAR(to_double(length), std::sqrt(to_double(c.squared_force(friction))), kNearly);
  }
}

// A margin's loads and preloads grow with its multiple.
TEST(AnsweringForces, GrowWithTheMultiple) {
  RandomSource random(316);
  GraspBox box = test::random_law_box(random, false);
  for (UncertainContact& c : box.contacts) c.slope = 0;
  box = box.middle();
  Growth growth{{1, 2, 3}, std::vector<Rational>(box.contacts.size(), 5)};
  const GraspLaw law(box, NormalLaw::kUnilateral, kDefaultBits, growth);
  const Rational multiple(3, 2);
  const degree_detail::WrenchRange loads = degree_detail::loads_at(law, multiple);
  for (std::size_t j = 0; j < 3; ++j) {
    const Rational expected = box.wrench[j].low + multiple * growth.load[j];
    EXPECT_EQ(loads[j].low, expected);
    EXPECT_EQ(loads[j].high, expected);
  }
  const LawContact& c = law.contacts.front();
  const Interval preload = degree_detail::preload_at(c, multiple);
  EXPECT_EQ(preload.low, c.preload.low + multiple * c.rate.low);
  EXPECT_EQ(c.rate.low * box.contacts.front().preload.low, 5 * c.preload.low);
}

}  // namespace rounded_box_test
}  // namespace stickslip
