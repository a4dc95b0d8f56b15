// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/snap.hpp"

#include <utility>

#include "short_arithmetic.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using namespace core_detail;

namespace {

Rational dot(const Vector2& a, const Vector2& b) {
  return a.x * b.x + a.y * b.y;
}
struct Fraction {
  Integer num;
  Integer den;

  /// The unit vector of the circle's parametrisation at t = num/den.
  Vector2 on_circle() const {
    const Integer a = num * num;
    const Integer b = den * den;
    return {Rational(b - a, a + b), Rational(2 * num * den, a + b)};
  }
};

/// A direction in the first octant, 0 <= y <= x, whose length is irrational.
class Target {
 public:
  Target(Vector2 direction, const Rational& tolerance)
      : direction_(std::move(direction)), length_squared_(dot(direction_, direction_)) {
    const Rational cosine = 1 - tolerance * tolerance / 2;
    threshold_ = cosine * cosine * length_squared_;
  }

  /// |u - n/L| <= tolerance <=> u.n >= L (1 - tolerance^2/2), squared: no root is taken.
  bool accepts(const Fraction& t) const {
    const Rational projection = dot(t.on_circle(), direction_);
    return projection.sign() > 0 && projection * projection >= threshold_;
  }

  /// Whether t lies below the parameter of the direction (never equal: that is irrational).
  bool above(const Fraction& t) const {
    return determinant(t.on_circle(), direction_).sign() > 0;
  }

  /// |u - n/L|^2 = 2 s^2 / (1 + c) with s, c the sine and cosine between u and n: no
  /// cancellation, so a few digits suffice at any tolerance.
  std::string distance_bound(const Vector2& u) const {
    const Rational s = determinant(u, direction_);
    const Rational c = dot(u, direction_);
    const Rational cosine = parse_rational(enclose_sqrt(1, c * c / length_squared_).lower);
    return enclose_sqrt(1, 2 * s * s / (length_squared_ * (1 + cosine)), 3).upper;
  }

 private:
  Vector2 direction_;
  Rational length_squared_;
  Rational threshold_;
};

Fraction mediant(const Fraction& fixed, const Integer& times, const Fraction& end) {
  return {fixed.num + times * end.num, fixed.den + times * end.den};
}

/// The simplest fraction that `target` accepts. It lies on the Stern-Brocot path to the
/// target's own irrational parameter, because that parameter is inside the accepted interval.
/// Steps in one direction are taken by doubling and bisection, so a parameter of 1e-20 costs
/// 67 steps and not 1e20.
Fraction simplest(const Target& target) {
  Fraction low{0, 1};
  Fraction high{1, 1};
  if (target.accepts(low)) return low;
  // Not so `high`: t <= tan(22.5 degrees) is nearer to 0 than to 1.
  for (bool upward = false;; upward = !upward) {
    Fraction& moving = upward ? low : high;
    const Fraction& end = upward ? high : low;
    // A step falls short while it is still on the side of `moving` and not accepted.
    const auto short_of = [&](const Integer& times) {
      const Fraction t = mediant(moving, times, end);
      return target.above(t) == upward && !target.accepts(t);
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
    if (target.accepts(candidate)) return candidate;
    moving = mediant(moving, reached, end);
  }
}

Rational with_sign_of(const Rational& magnitude, const Rational& sign) {
  return sign.sign() < 0 ? Rational(-magnitude) : magnitude;
}

}  // namespace

SnapResult snap_normals(const Grasp& grasp, const Rational& tolerance) {
  if (tolerance.sign() <= 0 || tolerance >= 1) {
    throw InputError("", "within", "the value is " + to_string(tolerance),
                     "it must lie between 0 and 1, such as 1e-9");
  }
  std::vector<Contact> contacts = grasp.contacts();
  std::vector<SnappedNormal> snapped;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Vector2 n = contacts[i].normal;
    if (exact_sqrt(dot(n, n))) continue;
    const Rational x = abs(n.x);
    const Rational y = abs(n.y);
    const bool steep = y > x;
    const Target target(steep ? Vector2{y, x} : Vector2{x, y}, tolerance);
    const Vector2 u = simplest(target).on_circle();
    const Vector2 after{with_sign_of(steep ? u.y : u.x, n.x),
                        with_sign_of(steep ? u.x : u.y, n.y)};
    contacts[i].normal = after;
    snapped.push_back({ContactId(i), n, after, target.distance_bound(u)});
  }
  return {Grasp(std::move(contacts), grasp.description()), std::move(snapped)};
}

}  // namespace stickslip
