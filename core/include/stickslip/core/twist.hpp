// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Small planar motions and forces in the object frame, and their pairing.
///
/// A Twist d = (x, y, r) moves the point p to p + (x - r p_y, y + r p_x). A Wrench
/// w = (x, y, torque) is a force and its torque about the origin of the object frame.
/// The two are dual and meet only in `power`. Units are the user's; r is in radians
/// (small-angle), so torque has units of force times length.
#pragma once

#include <array>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip {

/// A vector in Q^3 without physical meaning: a plane normal, a ray's coordinates.
using Vector3 = std::array<Rational, 3>;

/// A small planar motion d = (x, y, r) of the object.
struct Twist {
  Rational x{};  ///< displacement of the origin of the frame along x, a length
  Rational y{};  ///< displacement of the origin of the frame along y, a length
  Rational r{};  ///< rotation, counterclockwise, in radians

  /// Compares exactly.
  friend bool operator==(const Twist& a, const Twist& b) {
    return a.x == b.x && a.y == b.y && a.r == b.r;
  }
};

/// A planar force and its torque, w = (x, y, torque), on the object.
struct Wrench {
  Rational x{};       ///< force along x
  Rational y{};       ///< force along y
  Rational torque{};  ///< about the origin of the frame, counterclockwise

  /// Compares exactly.
  friend bool operator==(const Wrench& a, const Wrench& b) {
    return a.x == b.x && a.y == b.y && a.torque == b.torque;
  }
  /// \{ Adds components, for forces that act together, or multiplies them by a number.
  Wrench& operator+=(const Wrench& other) {
    x += other.x;
    y += other.y;
    torque += other.torque;
    return *this;
  }
  friend Wrench operator+(Wrench a, const Wrench& b) { return a += b; }
  friend Wrench operator*(const Rational& factor, const Wrench& w) {
    return {factor * w.x, factor * w.y, factor * w.torque};
  }
  /// \}
};

/// Returns the virtual work of `wrench` on `twist`: w_x x + w_y y + w_torque r.
inline Rational power(const Wrench& wrench, const Twist& twist) {
  return wrench.x * twist.x + wrench.y * twist.y + wrench.torque * twist.r;
}

/// \{ Returns the three components as a plain vector, without their physical meaning.
inline Vector3 coordinates(const Twist& d) {
  return {d.x, d.y, d.r};
}
inline Vector3 coordinates(const Wrench& w) {
  return {w.x, w.y, w.torque};
}
/// \}

/// Returns the motion with these coordinates.
inline Twist twist_of(const IntegerVector<3>& d) {
  return {Rational(d[0]), Rational(d[1]), Rational(d[2])};
}

}  // namespace stickslip
