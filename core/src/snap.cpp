// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/snap.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "short_arithmetic.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip {

using namespace core_detail;

namespace {

using stickslip::dot;
Rational dot(const Vector2& a, const Vector2& b) {
  return a.x * b.x + a.y * b.y;
}

/// A direction in the plane or in space whose length is irrational.
template <class Vector>
class Target {
 public:
  Target(Vector direction, const Rational& tolerance)
      : direction_(std::move(direction)), length_squared_(dot(direction_, direction_)) {
    const Rational cosine = 1 - tolerance * tolerance / 2;
    threshold_ = cosine * cosine * length_squared_;
  }

  const Vector& direction() const { return direction_; }

  /// Returns whether a unit vector u is near enough: |u - n/L| <= tolerance <=> u.n >= L (1 -
  /// tolerance^2/2). Both sides are squared, so that no root is taken.
  bool accepts(const Vector& u) const {
    const Rational projection = dot(u, direction_);
    return projection.sign() > 0 && projection * projection >= threshold_;
  }

  /// Returns an upper bound of |u - n/L|. Its square is 2 s^2 / (1 + c) with s, c the sine and
  /// cosine between u and n; s^2 L^2 is exact, so a few digits suffice at any tolerance.
  std::string distance_bound(const Vector& u) const {
    const Rational c = dot(u, direction_);
    const Rational s_squared = length_squared_ - c * c;
    const Rational cosine = parse_rational(enclose_sqrt(1, c * c / length_squared_).lower);
    return enclose_sqrt(1, 2 * s_squared / (length_squared_ * (1 + cosine)), 3).upper;
  }

 private:
  Vector direction_;
  Rational length_squared_;
  Rational threshold_;
};

struct Fraction {
  Integer num;
  Integer den;

  /// Returns the unit vector of the circle's parametrisation at t = num/den.
  Vector2 on_circle() const {
    const Integer a = num * num;
    const Integer b = den * den;
    return {Rational(b - a, a + b), Rational(2 * num * den, a + b)};
  }
};

Fraction mediant(const Fraction& fixed, const Integer& times, const Fraction& end) {
  return {fixed.num + times * end.num, fixed.den + times * end.den};
}

/// Returns the unit vector of the simplest fraction whose vector is accepted. Requires a
/// direction in the first octant, 0 <= y <= x. The fraction lies on the Stern-Brocot path to
/// the target's own irrational parameter, because that parameter is inside the accepted
/// interval. Steps in one direction are taken by doubling and bisection, so a parameter of
/// 1e-20 costs 67 steps and not 1e20.
Vector2 nearby_unit(const Target<Vector2>& target) {
  Fraction low{0, 1};
  Fraction high{1, 1};
  const auto accepted = [&](const Fraction& t) { return target.accepts(t.on_circle()); };
  // `below(t)` says whether t lies below the parameter of the direction (never equal: that is
  // irrational).
  const auto below = [&](const Fraction& t) {
    return determinant(t.on_circle(), target.direction()).sign() > 0;
  };
  if (accepted(low)) return low.on_circle();
  // `high` is not accepted either, as t <= tan(22.5 degrees) is nearer to 0 than to 1.
  for (bool upward = false;; upward = !upward) {
    Fraction& moving = upward ? low : high;
    const Fraction& end = upward ? high : low;
    // A step falls short while it is still on the side of `moving` and not accepted.
    const auto short_of = [&](const Integer& times) {
      const Fraction t = mediant(moving, times, end);
      return below(t) == upward && !accepted(t);
    };
    Integer reached = 0;
    Integer beyond = 1;
    while (short_of(beyond)) {
      reached = beyond;
      beyond *= 2;
    }
    while (beyond - reached > 1) {
      const Integer middle = (reached + beyond) / 2;
      (short_of(middle) ? reached : beyond) = middle;
    }
    const Fraction candidate = mediant(moving, beyond, end);
    if (accepted(candidate)) return candidate.on_circle();
    moving = mediant(moving, reached, end);
  }
}

/// Returns the whole part of a number >= 0.
Integer whole_part(const Rational& value) {
  return numerator(value) / denominator(value);
}

/// Returns an accepted unit vector for a direction with 0 <= x, y <= z > 0. The entries s =
/// x/(|n| + z) and t are rounded to multiples of 1/2, 1/4, ... until the point of the sphere is
/// accepted: a distance of h in each moves it by less than 3 h.
Vector3 nearby_unit(const Target<Vector3>& target) {
  const Vector3& n = target.direction();
  const Rational x = n[0] / n[2];
  const Rational y = n[1] / n[2];
  const Rational squared = 1 + x * x + y * y;
  for (unsigned bits = 1;; ++bits) {
    const Integer q = Integer(1) << bits;
    const Integer fine = q * 16;  // proposes; accepts() disposes
    const Rational length(sqrt(whole_part(squared * Rational(fine * fine))), fine);
    const auto rounded = [&](const Rational& entry) {
      return whole_part(q * entry / (length + 1) + Rational(1, 2));
    };
    const Integer a = rounded(x);
    const Integer b = rounded(y);
    const Integer plus = q * q + a * a + b * b;
    const Vector3 u{Rational(2 * a * q, plus), Rational(2 * b * q, plus),
                    Rational(q * q - a * a - b * b, plus)};
    if (target.accepts(u)) return u;
  }
}

Rational with_sign_of(const Rational& magnitude, const Rational& sign) {
  return sign.sign() < 0 ? Rational(-magnitude) : magnitude;
}

/// Returns the unit vector near n, and how far it is away at most; nothing if n has a rational
/// length.
std::optional<std::pair<Vector2, std::string>> snapped(const Vector2& n,
                                                       const Rational& tolerance) {
  if (exact_sqrt(dot(n, n))) return std::nullopt;
  const Rational x = abs(n.x);
  const Rational y = abs(n.y);
  const bool steep = y > x;
  const Target target(steep ? Vector2{y, x} : Vector2{x, y}, tolerance);
  const Vector2 u = nearby_unit(target);
  return std::pair(
      Vector2{with_sign_of(steep ? u.y : u.x, n.x), with_sign_of(steep ? u.x : u.y, n.y)},
      target.distance_bound(u));
}

std::optional<std::pair<Vector3, std::string>> snapped(const Vector3& n,
                                                       const Rational& tolerance) {
  if (exact_sqrt(dot(n, n))) return std::nullopt;
  Vector3 sizes{abs(n[0]), abs(n[1]), abs(n[2])};
  Rational& largest = *std::max_element(sizes.begin(), sizes.end());
  const auto axis = static_cast<std::size_t>(&largest - sizes.data());
  std::swap(sizes[axis], sizes[2]);
  const Target target(sizes, tolerance);
  Vector3 u = nearby_unit(target);
  std::string moved = target.distance_bound(u);
  std::swap(u[axis], u[2]);
  for (std::size_t j = 0; j < 3; ++j) u[j] = with_sign_of(u[j], n[j]);
  return std::pair(u, std::move(moved));
}

std::optional<SnappedNormal> snapped(ContactId contact, const RationalRow& n,
                                     const Rational& tolerance) {
  if (n.size() == 2) {
    auto found = snapped(Vector2{n[0], n[1]}, tolerance);
    if (!found) return std::nullopt;
    auto& [u, moved] = *found;
    return SnappedNormal{contact, n, {u.x, u.y}, std::move(moved)};
  }
  auto found = snapped(vector3(n), tolerance);
  if (!found) return std::nullopt;
  auto& [u, moved] = *found;
  return SnappedNormal{contact, n, {u.begin(), u.end()}, std::move(moved)};
}

RationalRow normal_of(const Contact& c) {
  return {c.normal.x, c.normal.y};
}

const RationalRow& normal_of(const UncertainContact& c) {
  return c.normal;
}

void set_normal(Contact& c, const RationalRow& n) {
  c.normal = {n[0], n[1]};
}

void set_normal(UncertainContact& c, const RationalRow& n) {
  c.normal = n;
}

/// Snaps the normals of contacts in the plane or in space, and returns the replaced ones.
template <class Contact>
std::vector<SnappedNormal> snap_contacts(std::vector<Contact>& contacts,
                                         const Rational& tolerance) {
  if (tolerance.sign() <= 0 || tolerance >= 1) {
    throw InputError("", "within", "the value is " + to_string(tolerance),
                     "it must lie between 0 and 1, such as 1e-9");
  }
  std::vector<SnappedNormal> result;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (auto found = snapped(ContactId(i), normal_of(contacts[i]), tolerance)) {
      set_normal(contacts[i], found->after);
      result.push_back(std::move(*found));
    }
  }
  return result;
}

}  // namespace

SnapResult snap_normals(const Grasp& grasp, const Rational& tolerance) {
  std::vector<Contact> contacts = grasp.contacts();
  std::vector<SnappedNormal> snapped = snap_contacts(contacts, tolerance);
  return {Grasp(std::move(contacts), grasp.description()), std::move(snapped)};
}

BoxSnapResult snap_normals(const GraspBox& grasp, const Rational& tolerance) {
  BoxSnapResult result{grasp, {}};
  result.snapped = snap_contacts(result.grasp.contacts, tolerance);
  return result;
}

}  // namespace stickslip
