// SPDX-License-Identifier: MIT
/// \file
/// Numbers that are known to lie between two doubles. Each operation encloses all of its exact
/// results: doubles round them (IEEE 754, to nearest) by a relative 2^-53, or where they are
/// below 2^-1022 by less than 2^-1000, and what GMP gives for a number of its own is cut off by
/// less than a relative 2^-52. Both ends move outwards by more than that. An overflow, or what
/// is no number, makes an enclosure of everything.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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
  friend Enclosure operator*(const Enclosure& a, const Enclosure& b) {
    const Products of(a, b);
    return std::isnan(of.sum) ? everything() : outwards(of.least, of.most);
  }
  /// This encloses a sum of products of as many numbers as the shorter one has, n of them. All
  /// that is rounded is below (n + 2) / 2^53 of the sum of sizes.
  friend Enclosure product(const std::vector<Enclosure>& a, const std::vector<Enclosure>& b) {
    double low = 0;
    double high = 0;
    double size = 0;
    double sum = 0;
    const std::size_t n = std::min(a.size(), b.size());
    for (std::size_t j = 0; j < n; ++j) {
      const Products of(a[j], b[j]);
      low += of.least;
      high += of.most;
      size += std::max(std::fabs(of.least), std::fabs(of.most));
      sum += of.sum;
    }
    if (std::isnan(sum) || !(size <= kMost)) return everything();
    const double off = static_cast<double>(n) * (size * kRelative + kLeast);
    return Enclosure(low - off, high + off);
  }
  /// These enclose the larger and the smaller of two numbers.
  friend Enclosure larger(const Enclosure& a, const Enclosure& b) {
    return Enclosure(std::max(a.low_, b.low_), std::max(a.high_, b.high_));
  }
  friend Enclosure smaller(const Enclosure& a, const Enclosure& b) {
    return Enclosure(std::min(a.low_, b.low_), std::min(a.high_, b.high_));
  }
  /// This encloses "the bound" (FORMAT.md §6) of the root of a, which has no number below 0.
  /// The bound is not below the root, and above it by less than a relative 2^-62.
  friend Enclosure root_above(const Enclosure& a) {
    return outwards(std::sqrt(std::max(a.low_, 0.0)), std::sqrt(std::max(a.high_, 0.0)));
  }
  /// This encloses that of a times the root of a square; a may be below 0.
  friend Enclosure times_root_above(const Enclosure& a, const Enclosure& square) {
    return a * root_above(square);
  }

 private:
  static constexpr double kRelative = 0x1p-50;
  static constexpr double kLeast = 0x1p-1000;
  static constexpr double kMost = 0x1p1000;

  Enclosure(double low, double high) : low_(low), high_(high) {}

  /// The products of the ends of two, as doubles round them.
  struct Products {
    Products(const Enclosure& a, const Enclosure& b) {
      const double p = a.low_ * b.low_;
      const double q = a.low_ * b.high_;
      const double r = a.high_ * b.low_;
      const double s = a.high_ * b.high_;
      least = std::min(std::min(p, q), std::min(r, s));
      most = std::max(std::max(p, q), std::max(r, s));
      sum = p + q + r + s;
    }
    double least;
    double most;
    double sum;  ///< no number if one of infinity and 0 is none, which the others pass over
  };

  static Enclosure everything() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return Enclosure(-kInfinity, kInfinity);
  }

  static Enclosure outwards(double low, double high) {
    if (std::fabs(low) <= kMost && std::fabs(high) <= kMost) {
      return Enclosure(low - (std::fabs(low) * kRelative + kLeast),
                       high + (std::fabs(high) * kRelative + kLeast));
    }
    return everything();
  }

  double low_ = 0;
  double high_ = 0;
};

}  // namespace stickslip_check
