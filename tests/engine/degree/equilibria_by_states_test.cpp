// SPDX-License-Identifier: GPL-3.0-or-later
// All equilibria of a grasp in the plane, against every mode of every contact one by one.
#include "engine/degree/equilibria_by_states.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

namespace stickslip {
namespace {

constexpr double kClose = 1e-7;

/// Fingers around a disc of radius 1, under a load.
GraspBox fingers(std::size_t count, std::mt19937& random) {
  const auto number = [&](int least, int most) {
    return Rational(std::uniform_int_distribution<int>(least, most)(random), 100);
  };
  GraspBox box;
  for (std::size_t k = 0; k < count; ++k) {
    UncertainContact& c = box.contacts.emplace_back();
    const Rational t = number(-300, 300);  // any direction, by half of its tangent
    const Rational square = 1 + t * t;
    c.normal = {(1 - t * t) / square, 2 * t / square};
    c.position = {point_interval(number(-40, 40) - c.normal[0]),
                  point_interval(number(-40, 40) - c.normal[1])};
    c.friction = point_interval(number(10, 100));
    c.stiffness = point_interval(number(50, 200));
    c.preload = point_interval(number(0, 100));
  }
  for (int j = 0; j < 3; ++j) box.wrench.push_back(point_interval(number(-40, 40)));
  return box;
}

struct ByMode {
  Eigen::Vector3d motion;
  double orientation;  ///< the determinant of the equations
  bool presses_everywhere;
};

/// Returns all equilibria that are not at rest. Each contact is open, sticks, or slips one way
/// or the other; there are 4^m modes, and one system of equations for each.
std::vector<ByMode> of_all_modes(const RoundedGrasp& grasp) {
  const std::size_t m = grasp.contacts.size();
  std::size_t modes = 1;
  for (std::size_t i = 0; i < m; ++i) modes *= 4;
  std::vector<ByMode> found;
  for (std::size_t mode = 0; mode < modes; ++mode) {
    // The friction of each contact is an unknown beside the motion, as is its normal force.
    const auto n = static_cast<Eigen::Index>(3 + 2 * m);
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    b.head(3) = -grasp.load;
    std::vector<int> does;
    std::size_t rest = mode;
    for (std::size_t i = 0; i < m; ++i, rest /= 4) {
      does.push_back(static_cast<int>(rest % 4));  // open, sticks, slips +, slips -
      const RoundedContact& c = grasp.contacts[i];
      const auto normal = static_cast<Eigen::Index>(3 + 2 * i);
      const Eigen::Index friction = normal + 1;
      a.col(normal).head(3) = c.normal;
      a.col(friction).head(3) = c.slip.row(0).transpose();
      a(normal, normal) = 1;
      if (does[i] != 0) {
        a.row(normal).head(3) = c.stiffness * c.normal.transpose();
        b[normal] = c.preload;
      }
      if (does[i] == 1) {
        a.row(friction).head(3) = c.slip.row(0);
      } else {
        a(friction, friction) = 1;
        a(friction, normal) = does[i] == 0 ? 0 : does[i] == 2 ? c.slope : -c.slope;
      }
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(a);
    if (!lu.isInvertible()) continue;
    const Eigen::VectorXd x = lu.solve(b);
    const auto is_lawful = [&](std::size_t i) {
      const RoundedContact& c = grasp.contacts[i];
      const double v = c.preload - c.stiffness * c.normal.dot(x.head(3));
      const double slip = c.slip.row(0).dot(x.head(3));
      if (does[i] == 0) return v < 0;
      if (v <= 0) return false;
      if (does[i] == 1)
        return std::fabs(x[static_cast<Eigen::Index>(4 + 2 * i)]) <= c.slope * v;
      return does[i] == 2 ? slip > 0 : slip < 0;
    };
    bool lawful = true;
    for (std::size_t i = 0; i < m; ++i) lawful = lawful && is_lawful(i);
    if (!lawful || x.head(3).norm() <= kClose) continue;
    found.push_back(
        {x.head(3), lu.determinant(), std::count(does.begin(), does.end(), 0) == 0});
  }
  return found;
}

TEST(EquilibriaByStates, AreThoseOfAllModes) {
  std::mt19937 random(7);
  std::size_t several = 0;
  std::size_t all = 0;
  std::size_t missed = 0;
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE(trial);
    const GraspLaw law(fingers(2 + static_cast<std::size_t>(trial) % 4, random),
                       NormalLaw::kUnilateral);
    const RoundedGrasp grasp = rounded_middle(law);
    const std::vector<ByMode> expected = of_all_modes(grasp);
    std::vector<ByMode> found;
    for (const NearEquilibrium& near : equilibria_by_states(grasp)) {
      const auto same = std::find_if(expected.begin(), expected.end(), [&](const ByMode& e) {
        return (e.motion - near.motion).norm() <= kClose * (1 + e.motion.norm());
      });
      ASSERT_NE(same, expected.end());
      found.push_back(*same);
    }
    for (std::size_t k = 1; k < found.size(); ++k) {
      EXPECT_FALSE(found[k - 1].orientation > 0 && found[k].orientation < 0);
      if (found[k - 1].orientation * found[k].orientation < 0) continue;
      EXPECT_LT(found[k - 1].motion.norm(), found[k].motion.norm());
    }
    for (const ByMode& e : expected) {
      const auto is_it = [&](const ByMode& f) { return f.motion == e.motion; };
      const auto times = std::count_if(found.begin(), found.end(), is_it);
      EXPECT_EQ(times, e.presses_everywhere ? 1 : std::min<long>(times, 1));
      if (times == 0) ++missed;
    }
    all += expected.size();
    if (found.size() > 1) ++several;
  }
  EXPECT_GT(several, 20U);
  EXPECT_GT(all, 200U);
  EXPECT_LT(10 * missed, all);
}

TEST(EquilibriaByStates, AreOfOneBodyInThePlane) {
  std::mt19937 random(8);
  const GraspLaw law(fingers(kMostContactsOfStates + 1, random), NormalLaw::kUnilateral);
  EXPECT_TRUE(equilibria_by_states(rounded_middle(law)).empty());
}

}  // namespace
}  // namespace stickslip
