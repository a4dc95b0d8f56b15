// SPDX-License-Identifier: GPL-3.0-or-later
// The earlier methods in space: against the plane put into space, where Z3 has judged them;
// against closed forms; and against what sampled directions see of a wrench space.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/comparison.hpp"
#include "stickslip/earlier/compliance.hpp"
#include "stickslip/earlier/form_closure.hpp"
#include "stickslip/earlier/friction_cones.hpp"
#include "stickslip/earlier/grasp_wrench_space.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/engine/box_verdict.hpp"

namespace stickslip {
namespace {

using test::LoadCase;
using test::RandomSource;

Vector3 plus(Vector3 a, const Rational& factor, const Vector3& b) {
  for (std::size_t j = 0; j < 3; ++j) a[j] += factor * b[j];
  return a;
}

UncertainContact contact(const Vector3& p, const Vector3& n, const Rational& friction,
                         const Rational& preload = 0, const Rational& stiffness = 1) {
  UncertainContact c;
  for (const Rational& x : p) c.position.push_back(point_interval(x));
  c.normal = {n.begin(), n.end()};
  c.friction = point_interval(friction);
  c.preload = point_interval(preload);
  c.stiffness = point_interval(stiffness);
  return c;
}

GraspBox grasp_in_space(std::vector<UncertainContact> contacts, const Vector6& load) {
  GraspBox grasp{std::move(contacts), {}, {}};
  for (const Rational& w : load) grasp.wrench.push_back(point_interval(w));
  grasp.check();
  return grasp;
}

/// Turned into general position by a rational rotation.
Vector3 turned(const Vector3& v) {
  return {(2 * v[0] - v[1] + 2 * v[2]) / 3, (2 * v[0] + 2 * v[1] - v[2]) / 3,
          (2 * v[1] - v[0] + 2 * v[2]) / 3};
}

/// The plane put into space. What is loaded in its plane, with all springs in it, has its
/// equilibria there: motions out of it load nothing, and friction across it only takes from
/// the cone.
GraspBox put_into_space(const LoadedGrasp& loaded) {
  const Vector3 origin{1, -2, Rational(1, 2)};
  std::vector<UncertainContact> contacts;
  for (const Contact& c : loaded.grasp.contacts()) {
    contacts.push_back(contact(plus(turned({c.position.x, c.position.y, 0}), 1, origin),
                               turned({c.normal.x, c.normal.y, 0}), c.friction, c.preload,
                               c.stiffness));
  }
  const Wrench& w = loaded.wrench;
  const Vector3 force = turned({w.x, w.y, 0});
  const Vector3 torque = plus(turned({0, 0, w.torque}), 1, cross(origin, force));
  return grasp_in_space(std::move(contacts),
                        {force[0], force[1], force[2], torque[0], torque[1], torque[2]});
}

/// Loads of all kinds: far off, on borders, held by motions, and near borders.
std::vector<LoadCase> planar_cases(std::uint64_t seed, int count) {
  RandomSource random(seed);
  std::vector<LoadCase> result;
  for (int round = 0; round < count; ++round) {
    const auto m = static_cast<std::size_t>(random.between(1, 4));
    Grasp grasp =
        round % 3 == 0 ? test::generic_grasp(random, m) : test::degenerate_grasp(random, m);
    const NormalLaw law = round % 4 == 0 ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const int kind = random.between(0, 3);
    const Wrench w =
        kind == 0   ? test::small_wrench(random)
        : kind == 1 ? test::planted_wrench(random, grasp, law)
        : kind == 2 ? test::threshold_wrench(
                          random, grasp, random.one_in(2) ? Rational(0) : Rational(1, 1000000))
                    : Rational(1, 4) * test::small_wrench(random);
    result.push_back({{std::move(grasp), w}, law});
  }
  return result;
}

TEST(CompareInSpace, LinearComplianceOfThePlanePutIntoSpace) {
  std::size_t held = 0;
  std::size_t unresisted = 0;
  const std::vector<LoadCase> cases = planar_cases(11, 300);
  for (const LoadCase& c : cases) {
    const auto flat = linear_compliance(Problem(c.loaded, c.law));
    const auto deep = linear_compliance(put_into_space(c.loaded));
    const auto* in_plane = std::get_if<SpringBalance>(&flat);
    const auto* in_space = std::get_if<SpatialSpringBalance>(&deep);
    ASSERT_EQ(in_plane != nullptr, in_space != nullptr) << describe(c);
    if (in_plane == nullptr) {
      ++unresisted;
      continue;
    }
    EXPECT_EQ(in_plane->outside.has_value(), in_space->outside.has_value()) << describe(c);
    held += in_plane->outside ? 0 : 1;
    for (std::size_t i = 0; i < in_space->forces.size(); ++i) {
      const Vector2& n = c.loaded.grasp.contacts()[i].normal;
      const Vector2 f = force_vector(n, in_plane->springs.forces[i]);
      EXPECT_EQ(in_space->forces[i], turned({f.x, f.y, 0})) << describe(c);
    }
  }
  EXPECT_GE(held, 30U);
  EXPECT_GE(unresisted, 10U);
  EXPECT_LE(held + unresisted, 270U);
}

TEST(CompareInSpace, FrictionConesOfThePlanePutIntoSpace) {
  std::size_t held = 0;
  std::size_t undecided = 0;
  const std::vector<LoadCase> cases = planar_cases(12, 240);
  for (const LoadCase& c : cases) {
    const auto flat = friction_cones_alone(Problem(c.loaded, c.law));
    const auto deep = friction_cones_alone(put_into_space(c.loaded), c.law);
    if (std::holds_alternative<Undecided>(deep)) {
      ++undecided;  // exactly on a border
      continue;
    }
    const bool holds = std::holds_alternative<Witness>(flat);
    EXPECT_EQ(std::holds_alternative<SpatialConesWitness>(deep), holds) << describe(c);
    held += holds ? 1 : 0;
  }
  std::cout << held << " of " << cases.size() << " hold, " << undecided << " undecided\n";
  EXPECT_GE(held, 40U);
  EXPECT_LE(held, 200U);
  EXPECT_LE(undecided, 24U);
}

TEST(CompareInSpace, WhatIsFlatIsNotClosed) {
  for (const LoadCase& c : planar_cases(13, 40)) {
    const GraspBox grasp = put_into_space(c.loaded);
    EXPECT_TRUE(std::holds_alternative<FreeMotion>(form_closure(grasp)));
  }
}

/// On each face of a cube of side 2 two contacts that push inwards, aside of its middle, which
/// on opposite faces turn the cube opposite ways.
std::vector<UncertainContact> cube(const Rational& aside) {
  std::vector<UncertainContact> contacts;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {1, -1}) {
      for (const int end : {1, -1}) {
        Vector3 p{};
        Vector3 n{};
        p[axis] = side;
        p[(axis + 1) % 3] = end * aside;
        n[axis] = -side;
        contacts.push_back(contact(p, n, 0));
      }
    }
  }
  return contacts;
}

TEST(CompareInSpace, ACubeIsClosedUnlessItsContactsAreInTheMiddle) {
  EXPECT_TRUE(std::holds_alternative<FormClosure>(
      form_closure(grasp_in_space(cube(Rational(1, 2)), {}))));
  const auto turns = form_closure(grasp_in_space(cube(0), {}));
  ASSERT_TRUE(std::holds_alternative<FreeMotion>(turns));
  // Nothing on two opposite faces.
  for (long axis = 0; axis < 3; ++axis) {
    std::vector<UncertainContact> contacts = cube(Rational(1, 2));
    const auto first = contacts.begin() + 4 * axis;
    contacts.erase(first, first + 4);
    const auto free = form_closure(grasp_in_space(contacts, {}));
    ASSERT_TRUE(std::holds_alternative<FreeMotion>(free));
    // It moves towards them, or turns as they turned it.
    const Row& d = std::get<FreeMotion>(free).motion;
    for (std::size_t j = 0; j < 6; ++j) {
      const auto at = static_cast<std::size_t>(axis);
      const bool may_move = j == at || j == 3 + (at + 2) % 3;
      EXPECT_TRUE(may_move || d[j].is_zero());
    }
  }
}

// The hull of three rectangles (+-1, +-a) in orthogonal planes has the support max (|f| + a
// |t|), the least of which over unit vectors is min(a, 1) / sqrt(3).
TEST(CompareInSpace, TheWrenchSpaceOfACubeWithoutFriction) {
  for (const Rational& aside : {Rational(1, 2), Rational(1, 5)}) {
    for (const Rational& length : {Rational(1), Rational(2), Rational(1, 20)}) {
      const WrenchBall ball = wrench_ball(grasp_in_space(cube(aside), {}), length);
      const Rational a = std::min(Rational(aside / length), Rational(1));
      EXPECT_EQ(ball.low_squared, a * a / 3);
      EXPECT_EQ(ball.high_squared, a * a / 3);
    }
  }
}

double support(const GraspBox& grasp, const std::array<double, 6>& u) {
  double most = 0;
  for (const UncertainContact& c : grasp.contacts) {
    std::array<double, 3> p{};
    std::array<double, 3> n{};
    double length = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      p[j] = to_double(c.position[j].low);
      n[j] = to_double(c.normal[j]);
      length += n[j] * n[j];
    }
    const std::array<double, 3> v{u[0] + u[4] * p[2] - u[5] * p[1],
                                  u[1] + u[5] * p[0] - u[3] * p[2],
                                  u[2] + u[3] * p[1] - u[4] * p[0]};
    double along = 0;
    double all = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      along += v[j] * n[j] / std::sqrt(length);
      all += v[j] * v[j];
    }
    const double slip = std::sqrt(std::max(0.0, all - along * along));
    most = std::max(most, along + to_double(c.friction.low) * slip);
  }
  return most;
}

/// The least support that a search from many directions finds: not below the radius.
double sampled_radius(const GraspBox& grasp, RandomSource& random) {
  const auto value = [&](std::array<double, 6>& u) {
    double norm = 0;
    for (const double x : u) norm += x * x;
    for (double& x : u) x /= std::sqrt(norm);
    return support(grasp, u);
  };
  double best = HUGE_VAL;
  for (int start = 0; start < 40; ++start) {
    std::array<double, 6> u{};
    for (double& x : u) x = random.between(-1000, 1000) + 0.5;
    double here = value(u);
    double step = 0.5;
    while (step > 1e-7) {
      bool better = false;
      for (int trial = 0; trial < 30 && !better; ++trial) {
        std::array<double, 6> v = u;
        for (double& x : v) x += step * random.between(-1000, 1000) / 1000;
        const double there = value(v);
        better = there < here;
        if (better) {
          here = there;
          u = v;
        }
      }
      step *= better ? 1.2 : 0.6;
    }
    best = std::min(best, here);
  }
  return best;
}

TEST(CompareInSpace, TheWrenchSpaceAgainstSampledDirections) {
  RandomSource random(7);
  constexpr int kNormals[6][3] = {{1, 2, 2},  {-2, 1, 2}, {2, -2, -1},
                                  {-3, 0, 4}, {0, 0, -1}, {2, 3, -6}};
  std::size_t closed = 0;
  std::size_t open = 0;
  for (int round = 0; round < 12; ++round) {
    std::vector<UncertainContact> contacts;
    const std::size_t m = 3 + static_cast<std::size_t>(round) % 3;
    for (std::size_t i = 0; i < m; ++i) {
      const auto& n = kNormals[(i + static_cast<std::size_t>(random.between(0, 2))) % 6];
      const Vector3 normal{n[0], n[1], n[2]};
      const Vector3 aside{Rational(random.between(-5, 5), 10),
                          Rational(random.between(-5, 5), 10),
                          Rational(random.between(-5, 5), 10)};
      const Rational length =
          *exact_sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
      contacts.push_back(contact(plus(aside, -1 / length, normal), normal,
                                 Rational(random.between(4, 9), 10)));
    }
    const GraspBox grasp = grasp_in_space(std::move(contacts), {});
    const WrenchBall ball = wrench_ball(grasp);
    const double low = std::sqrt(to_double(ball.low_squared));
    const double high = std::sqrt(to_double(ball.high_squared));
    const double sampled = sampled_radius(grasp, random);
    EXPECT_LE(low, high);
    EXPECT_LE(low, sampled * (1 + 1e-9));
    // The search finds what is nearly the least.
    EXPECT_LE(high, sampled + 0.02);
    if (ball.high_squared.is_zero()) {
      ++open;
    } else if (!ball.low_squared.is_zero()) {
      ++closed;
      EXPECT_GE(low, 0.98999 * high) << ball.facets;
    }
    std::cout << m << " contacts: " << low << " to " << high << ", sampled " << sampled << ", "
              << ball.points << " points, " << ball.facets << " facets\n";
  }
  EXPECT_GE(closed, 3U);
  EXPECT_EQ(open, 2U);
}

/// Between two pads that press with 1 and have friction 1/2, of any direction across.
GraspBox pinch(const Vector3& load) {
  return grasp_in_space({contact(turned({-1, 0, 0}), turned({1, 0, 0}), Rational(1, 2), 1),
                         contact(turned({1, 0, 0}), turned({-1, 0, 0}), Rational(1, 2), 1)},
                        {load[0], load[1], load[2], 0, 0, 0});
}

TEST(CompareInSpace, APinchHoldsTheForceOfBothPads) {
  const Rational over = 1 + parse_rational("1e-18");
  for (const Vector3& across : {Vector3{0, 1, 0}, Vector3{0, Rational(3, 5), Rational(4, 5)}}) {
    for (const auto& [factor, holds] :
         {std::pair(Rational(1), true), std::pair(over, false), std::pair(1 / over, true)}) {
      const GraspBox grasp = pinch(turned(plus({}, factor, across)));
      const auto springs = linear_compliance(grasp);
      EXPECT_EQ(!std::get<SpatialSpringBalance>(springs).outside, holds);
      const auto cones = friction_cones_alone(grasp, NormalLaw::kUnilateral);
      if (factor != 1) {
        EXPECT_EQ(std::holds_alternative<SpatialConesWitness>(cones), holds);
      } else {
        EXPECT_FALSE(std::holds_alternative<NoSpatialCones>(cones));
      }
    }
  }
  const GraspBox twisted = grasp_in_space(pinch({}).contacts, {2, 2, -1, 1, 0, 0});
  ASSERT_TRUE(std::holds_alternative<UnresistedMotion>(linear_compliance(twisted)));
}

// What is passively stable has forces in the cones that obey the normal law, and these balance
// the load.
TEST(CompareInSpace, EachMethodAcceptsWhatAStricterOneDoes) {
  RandomSource random(31);
  constexpr int kNormals[5][3] = {{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {1, 2, 2}, {-2, 1, 2}};
  std::array<std::size_t, 4> seen{};  // how many accept
  for (int round = 0; round < 80; ++round) {
    std::vector<UncertainContact> contacts;
    for (int i = random.between(2, 4); i > 0; --i) {
      const auto& n = kNormals[random.between(0, 4)];
      contacts.push_back(
          contact({random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)},
                  {n[0], n[1], n[2]}, Rational(random.between(0, 4), 4), random.between(0, 2)));
    }
    const Rational part(random.between(1, 8), 8);
    // The opposite of forces within the cones, and a little more.
    Vector6 load{};
    for (const UncertainContact& c : contacts) {
      Vector3 force{};
      Vector3 point{};
      for (std::size_t j = 0; j < 3; ++j) {
        force[j] = -part * c.normal[j] + Rational(random.between(-2, 2), 8);
        point[j] = c.position[j].low;
      }
      const Vector3 torque = cross(point, force);
      for (std::size_t j = 0; j < 3; ++j) {
        load[j] += force[j];
        load[3 + j] += torque[j];
      }
    }
    const GraspBox grasp = grasp_in_space(std::move(contacts), load);
    const auto passive = decide_box(grasp, NormalLaw::kUnilateral).verdict;
    const auto cones = friction_cones_alone(grasp, NormalLaw::kUnilateral);
    const auto weak = weakly_stable_load(grasp);
    if (std::holds_alternative<Stable>(passive)) {
      ++seen[0];
      EXPECT_FALSE(std::holds_alternative<NoSpatialCones>(cones));
    }
    if (std::holds_alternative<SpatialConesWitness>(cones)) {
      ++seen[1];
      EXPECT_FALSE(std::holds_alternative<UnopposedMotion>(weak));
    }
    if (std::holds_alternative<RigidForces>(weak)) ++seen[2];
    if (std::holds_alternative<NoSpatialCones>(cones)) ++seen[3];
  }
  std::cout << seen[0] << " stable, " << seen[1] << " in cones, " << seen[2]
            << " weakly stable, " << seen[3] << " outside of cones\n";
  EXPECT_GE(seen[0], 8U);
  EXPECT_GT(seen[1], seen[0]);
  EXPECT_GT(seen[2], seen[1]);
  EXPECT_GE(seen[3], 8U);
}

TEST(CompareInSpace, MethodsOfThePlaneAreRefused) {
  NumberText text(false);
  const Question question{pinch(turned({0, 1, 0}))};
  for (const char* word : {"three-state-compliance", "grasp-wrench-space-Linf", "closure"}) {
    EXPECT_THROW(compare_methods(question, {{word}, 1, Inertia::of_length(1, true)}, text),
                 InputError);
  }
}

TEST(CompareInSpace, ALengthThatIsIrrationalIsSaid) {
  NumberText text(false);
  std::vector<UncertainContact> contacts = pinch({}).contacts;
  contacts[1].normal = {-1, -1, 0};
  const GraspBox grasp = grasp_in_space(contacts, {0, 0, -1, 0, 0, 0});
  EXPECT_THROW(linear_compliance(grasp), InputError);
  EXPECT_THROW(wrench_ball(grasp), InputError);
  const Comparison all =
      compare_methods(Question{grasp}, {{}, 1, Inertia::of_length(1, true)}, text);
  for (const MethodRow& row : all.methods) {
    const bool needs =
        row.method == "grasp wrench space, L1" || row.method == "linear compliance" ||
        row.method == "friction cones alone" || row.method == "potential contact robustness" ||
        row.method == "potential grasp robustness" || row.method == "least singular value" ||
        row.method == "volume of the wrench space" || row.method == "least normal forces" ||
        row.method == "margin of internal forces";
    EXPECT_EQ(row.verdict == kNotComputed, needs) << row.method;
    EXPECT_EQ(row.why.find("contacts[1].normal") != std::string::npos, needs) << row.why;
  }
}

}  // namespace
}  // namespace stickslip
