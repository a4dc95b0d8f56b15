// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_grasps.hpp"

#include <utility>

#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip::test {
namespace {

const Rational kHalf(1, 2);

Vector2 axis_normal(RandomSource& random) {
  return random.pick<Vector2>({{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
}

Rational friction(RandomSource& random) {
  return random.pick<Rational>({0, kHalf, 1});
}

Rational stiffness(RandomSource& random) {
  return random.pick<Rational>({1, 2, kHalf});
}

Rational small_fraction(RandomSource& random) {
  return Rational(random.between(-6, 6), random.between(1, 4));
}

/// ((1 - t^2), 2t) / (1 + t^2): of length 1.
Vector2 unit_vector(const Rational& t) {
  const Rational scale = 1 + t * t;
  return {(1 - t * t) / scale, 2 * t / scale};
}

Vector2 turned(const Vector2& v, const Vector2& by) {
  return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x};
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Twist small_twist(RandomSource& random) {
  return {Rational(random.between(-4, 4), 2), Rational(random.between(-4, 4), 2),
          Rational(random.between(-4, 4), 2)};
}

Twist proposed_motion(RandomSource& random, const std::vector<ContactRow>& rows) {
  const int sticking = rows.empty() ? 3 : random.between(0, 3);
  if (sticking == 0) return {};
  if (sticking == 3) return small_twist(random);
  const Vector3 first = coordinates(random.pick(rows).tangent);
  const Vector3 second =
      sticking == 2 ? coordinates(random.pick(rows).tangent) : coordinates(small_twist(random));
  const Vector3 axis = cross(first, second);
  const Rational scale(random.between(-3, 3), 2);
  return {scale * axis[0], scale * axis[1], scale * axis[2]};
}

bool closes_all(const std::vector<ContactRow>& rows, const Twist& d) {
  for (const ContactRow& row : rows) {
    if (row.normal_coefficient(d).sign() < 0) return false;
  }
  return true;
}

Rational offset(RandomSource& random, const Rational& epsilon) {
  return Rational(random.between(-1, 1)) * epsilon;
}

}  // namespace

std::string describe(const LoadCase& load_case) {
  return std::string(to_string(load_case.law)) + " normal law\n" +
         write_grasp(load_case.loaded);
}

Grasp degenerate_grasp(RandomSource& random, std::size_t contacts) {
  const int bound = random.between(1, 2);
  const bool uniform = random.one_in(3);
  const Contact shared{{}, {}, friction(random), stiffness(random), random.between(0, 1)};
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts; ++i) {
    Contact c =
        uniform ? shared
                : Contact{{}, {}, friction(random), stiffness(random), random.between(0, 1)};
    c.position = {random.between(-bound, bound), random.between(-bound, bound)};
    c.normal = axis_normal(random);
    result.push_back(std::move(c));
  }
  return Grasp(std::move(result));
}

Grasp generic_grasp(RandomSource& random, std::size_t contacts) {
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts; ++i) {
    Contact c;
    c.position = {small_fraction(random), small_fraction(random)};
    c.friction = Rational(random.between(0, 6), 4);
    c.stiffness = Rational(random.between(1, 6), random.between(1, 3));
    if (random.one_in(3)) {
      do {
        c.normal = {random.between(-3, 3), random.between(-3, 3)};
      } while (c.normal == Vector2{});
    } else {
      c.normal = turned(unit_vector(Rational(random.between(-9, 9), random.between(1, 9))),
                        axis_normal(random));
      const Rational length = random.pick<Rational>({1, 1, 3, kHalf});
      c.normal = {length * c.normal.x, length * c.normal.y};
      c.preload = Rational(random.between(0, 4), 2);
    }
    result.push_back(std::move(c));
  }
  return Grasp(std::move(result));
}

Grasp near_degenerate_grasp(RandomSource& random, std::size_t contacts,
                            const Rational& epsilon) {
  std::vector<Contact> result = degenerate_grasp(random, contacts).contacts();
  for (Contact& c : result) {
    c.position.x += offset(random, epsilon);
    c.position.y += offset(random, epsilon);
    c.normal = turned(c.normal, unit_vector(offset(random, epsilon)));
    const Rational preload = c.preload + offset(random, epsilon);
    if (preload.sign() >= 0) c.preload = preload;
  }
  return Grasp(std::move(result));
}

Wrench small_wrench(RandomSource& random) {
  const int denominator = random.between(1, 2);
  const int bound = 2 * denominator;
  return {Rational(random.between(-bound, bound), denominator),
          Rational(random.between(-bound, bound), denominator),
          Rational(random.between(-bound, bound), denominator)};
}

Wrench planted_wrench(RandomSource& random, const Grasp& grasp, NormalLaw law) {
  const std::vector<ContactRow> rows = contact_rows(grasp);
  Twist d = proposed_motion(random, rows);
  for (int attempt = 0; law == NormalLaw::kBilateral && !closes_all(rows, d); ++attempt) {
    d = attempt < 20 ? proposed_motion(random, rows) : Twist{};
  }
  Wrench wrench;
  for (const ContactRow& row : rows) {
    Rational a = row.normal_coefficient(d);
    if (a.sign() < 0) a = 0;
    const int slip = power(row.tangent, d).sign();
    const Rational share = slip != 0 ? Rational(-slip) : Rational(random.between(-2, 2), 2);
    wrench += -a * row.normal + -(share * row.friction * a) * row.tangent;
  }
  return wrench;
}

Wrench threshold_wrench(RandomSource& random, const Grasp& grasp, const Rational& epsilon) {
  Wrench wrench;
  for (const ContactRow& row : contact_rows(grasp)) {
    const Rational edge = Rational(random.one_in(2) ? 1 : -1) * row.friction;
    wrench += -row.preload * (row.normal + edge * row.tangent);
  }
  return wrench + epsilon * small_wrench(random);
}

}  // namespace stickslip::test
