// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reproducible random rationals and grasps for property tests.
#pragma once

#include <iterator>
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

  /// 0, or at a border of what a double, half a machine word, a word or several hold.
  Integer border() {
    constexpr int kBits[] = {0, 1, 30, 31, 32, 52, 53, 62, 63, 64, 65, 127, 128, 300};
    const int bits = kBits[integer(0, static_cast<int>(std::size(kBits)) - 1)];
    const Integer value = (Integer(1) << static_cast<unsigned>(bits)) + integer(-1, 1);
    return integer(0, 1) == 0 ? value : Integer(-value);
  }

  /// A fraction of such numbers or small ones; often an integer.
  Rational extreme() {
    const auto part = [&] { return integer(0, 1) == 0 ? border() : Integer(integer(-9, 9)); };
    const Integer denominator = integer(0, 2) == 0 ? Integer(1) : Integer(abs(part()));
    return Rational(part(), denominator.is_zero() ? Integer(1) : denominator);
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
