// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/space/near_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip {
namespace {

using Double3 = std::array<double, 3>;
using Double6 = std::array<double, 6>;

/// Of what moves furthest, what is no slip.
constexpr double kNoSlip = 1e-6;
constexpr int kRounds = 5000;

double norm(const Double3& a) {
  return std::hypot(a[0], a[1], a[2]);
}
Double3 added(Double3 a, double factor, const Double3& b) {
  for (std::size_t j = 0; j < 3; ++j) a[j] += factor * b[j];
  return a;
}
Double3 doubles(const Vector3& a) {
  return {to_double(a[0]), to_double(a[1]), to_double(a[2])};
}
Vector3 rationals(const Double3& a) {
  return {rational_from_double(a[0]), rational_from_double(a[1]), rational_from_double(a[2])};
}

struct Finger {
  Double3 position;  ///< in units of the size of the grasp
  Double3 normal;    ///< of length 1
  double press = 0;  ///< the normal force
  double most = 0;   ///< of friction
  Double3 slip;
  Double3 friction{};
  bool sticks = false;
};

/// Shortens what is longer than `most` to it, after it is put into the tangent plane.
Double3 into_cone(const Finger& finger, Double3 friction) {
  friction = added(friction, -stickslip::dot(friction, finger.normal), finger.normal);
  const double size = norm(friction);
  return size <= finger.most ? friction : added({}, finger.most / size, friction);
}

/// Load and forces, the torque in units of the size.
Double6 imbalance(const std::vector<Finger>& fingers, const Double6& load) {
  Double6 total = load;
  for (const Finger& f : fingers) {
    const Double3 force = added(f.friction, f.press, f.normal);
    const Double3 torque = stickslip::cross(f.position, force);
    for (std::size_t j = 0; j < 3; ++j) {
      total[j] += force[j];
      total[j + 3] += torque[j];
    }
  }
  return total;
}

/// Friction of what sticks: projected gradients with Nesterov's momentum.
void balance(std::vector<Finger>& fingers, const Double6& load) {
  double steep = 1;
  for (const Finger& f : fingers) steep += 1 + stickslip::dot(f.position, f.position);
  std::vector<Double3> last;
  for (const Finger& f : fingers) last.push_back(f.friction);
  double momentum = 1;
  for (int round = 0; round < kRounds; ++round) {
    const Double6 off = imbalance(fingers, load);
    const double next = (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
    for (std::size_t i = 0; i < fingers.size(); ++i) {
      Finger& f = fingers[i];
      if (!f.sticks) continue;
      const Double3 pull = added({off[0], off[1], off[2]}, 1,
                                 stickslip::cross({off[3], off[4], off[5]}, f.position));
      const Double3 found = into_cone(f, added(f.friction, -1 / steep, pull));
      f.friction = added(found, (momentum - 1) / next, added(found, -1, last[i]));
      last[i] = found;
    }
    momentum = next;
  }
  for (std::size_t i = 0; i < fingers.size(); ++i) fingers[i].friction = last[i];
}

}  // namespace

std::vector<SpatialForce> near_forces(const SpatialQuestion& question, const Vector6& d) {
  const SpatialGrasp& grasp = question.grasp;
  Rational size = 0;
  for (const SpatialContact& c : grasp.contacts) {
    for (const Interval& x : c.position) size = std::max(size, Rational(abs(x.middle())));
  }
  if (size.is_zero()) size = 1;
  std::vector<Finger> fingers;
  double furthest = 0;
  for (const SpatialContact& c : grasp.contacts) {
    const Vector3 p{c.position[0].middle(), c.position[1].middle(), c.position[2].middle()};
    const Double3 moved = doubles(stickslip::displacement(p, d));
    const Rational largest = std::max(
        {Rational(abs(c.normal[0])), Rational(abs(c.normal[1])), Rational(abs(c.normal[2]))});
    Finger& f = fingers.emplace_back();
    f.position = doubles({p[0] / size, p[1] / size, p[2] / size});
    f.normal = doubles({c.normal[0] / largest, c.normal[1] / largest, c.normal[2] / largest});
    f.normal = added({}, 1 / norm(f.normal), f.normal);
    const double rise = stickslip::dot(f.normal, moved);
    f.press =
        std::max(0.0, to_double(c.preload.middle()) - to_double(c.stiffness.middle()) * rise);
    f.most = to_double(c.friction.middle()) * f.press;
    f.slip = added(moved, -rise, f.normal);
    furthest = std::max(furthest, norm(moved));
  }
  for (Finger& f : fingers) {
    f.sticks = norm(f.slip) <= kNoSlip * furthest;
    if (f.sticks) {
      f.slip = {};
    } else {
      f.friction = added({}, -f.most / norm(f.slip), f.slip);
    }
  }
  Double6 load{};
  for (std::size_t j = 0; j < 6; ++j) {
    const Rational w = question.grasp.wrench[j].middle();
    load[j] = to_double(j < 3 ? w : Rational(w / size));
  }
  balance(fingers, load);
  std::vector<SpatialForce> forces;
  for (const Finger& f : fingers) {
    forces.push_back({rational_from_double(f.press), rationals(f.slip), rationals(f.friction),
                      rationals(added(f.friction, f.press, f.normal))});
  }
  return forces;
}

}  // namespace stickslip
