// SPDX-License-Identifier: MIT
/// \file
/// Numbers that are known to lie between two doubles. Each operation encloses all of its exact
/// results: doubles round them (IEEE 754, to nearest) by a relative 2^-53, or where they are
/// below 2^-1022 by less than 2^-1000, and what GMP gives for a number of its own is cut off by
/// less than a relative 2^-52. Both ends move outwards by more than that. An overflow, or what
/// is no number, makes an enclosure of everything.
#pragma once

#include "number.hpp"

namespace stickslip_check {

class Enclosure {
 public:
  /// 0.
  Enclosure() = default;
  explicit Enclosure(const Integer& x);
  explicit Enclosure(const Rational& x);
  /// x / 2^exponent.
  Enclosure(const Integer& x, long exponent);

  double low() const { return low_; }
  double high() const { return high_; }

  friend Enclosure operator+(const Enclosure& a, const Enclosure& b) {
    return outwards(a.low_ + b.low_, a.high_ + b.high_);
  }
  friend Enclosure operator-(const Enclosure& a, const Enclosure& b) {
    return outwards(a.low_ - b.high_, a.high_ - b.low_);
  }
  friend Enclosure operator*(const Enclosure& a, const Enclosure& b);
  /// These enclose the larger and the smaller of two numbers.
  friend Enclosure larger(const Enclosure& a, const Enclosure& b);
  friend Enclosure smaller(const Enclosure& a, const Enclosure& b);
  /// This encloses "the bound" (FORMAT.md §6) of the root of a, which has no number below 0. The
  /// bound is not below the root, and above it by less than a relative 2^-62.
  friend Enclosure root_above(const Enclosure& a);
  /// This encloses that of a times the root of a square; a may be below 0.
  friend Enclosure times_root_above(const Enclosure& a, const Enclosure& square);

 private:
  static Enclosure outwards(double low, double high);

  double low_ = 0;
  double high_ = 0;
};

}  // namespace stickslip_check
