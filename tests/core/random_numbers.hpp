// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reproducible random rationals and grasps for property tests.
#pragma once

#include <random>
#include <vector>

#include "stickslip/core/grasp.hpp"

namespace stickslip::testing {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  int integer(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(engine_);
  }

  /// Small numerators and denominators, zero included.
  Rational small() { return Rational(integer(-9, 9), integer(1, 7)); }

  Integer digits(int count) {
    Integer value = 0;
    for (int i = 0; i < count; ++i) value = 10 * value + integer(0, 9);
    return value;
  }

  /// Up to `length` digits above and below the line.
  Rational big(int length) {
    const Rational value(digits(integer(1, length)), digits(integer(0, length)) + 1);
    return integer(0, 1) == 0 ? value : Rational(-value);
  }

  Vector2 nonzero_vector() {
    Vector2 v{small(), small()};
    return v == Vector2{} ? Vector2{1, 0} : v;
  }

  Contact contact() {
    return {{small(), small()}, nonzero_vector(), abs(small()), abs(small()) + 1, abs(small())};
  }

  std::vector<Contact> contacts(int count) {
    std::vector<Contact> result;
    for (int i = 0; i < count; ++i) result.push_back(contact());
    return result;
  }

  Twist twist() { return {small(), small(), small()}; }
  Wrench wrench() { return {small(), small(), small()}; }

  std::mt19937& engine() { return engine_; }

 private:
  std::mt19937 engine_;
};

inline bool same(const Contact& a, const Contact& b) {
  return a.position == b.position && a.normal == b.normal && a.friction == b.friction &&
         a.stiffness == b.stiffness && a.preload == b.preload;
}

}  // namespace stickslip::testing
