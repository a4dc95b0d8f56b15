// SPDX-License-Identifier: MIT
/// \file
/// The loads of a box of parameters: each component of w in an interval, or a ball of them
/// (FORMAT.md §6). Trees, parts at rest and free motions know of them what work they do.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "number.hpp"

namespace stickslip_check {

/// The wrenches of a force f and a torque t at a point with |f|^2 + |t|^2 / length^2 <=
/// radius^2.
struct Ball {
  Rational radius;
  Rational length = 1;
  Vector about;                     ///< the point; empty if it is 0 and was left out
  std::optional<std::string> body;  ///< of several bodies, the one that they are on

  bool operator==(const Ball& other) const {
    return radius == other.radius && length == other.length && about == other.about &&
           body == other.body;
  }
};

/// All w = w0 + sum z_j B_j, with each of the numbers z_j in its interval; of a ball only those
/// z that are in it.
class Load {
 public:
  Load() = default;
  /// Components, which are the numbers.
  explicit Load(std::vector<Bounds> components);
  /// To w0 are added those of a ball, whose point is given, on a body that moves by `motion`
  /// times the motion of all.
  Load(Vector w0, const Ball& ball, const Matrix& motion);

  std::size_t dimension() const { return w0_.size(); }
  const std::vector<Bounds>& numbers() const { return numbers_; }
  /// Whether it is one.
  bool certain() const;
  /// The one that all numbers have at their low ends.
  Vector lowest() const;
  /// From -Lambda(-y) to Lambda(y): no load does more work on y, or less.
  Bounds work(const Vector& y) const;

  Load with(std::size_t index, Bounds bounds) const;
  /// The one in the middle of all intervals; of a ball that with the least z.
  Load middle() const;

 private:
  Vector w0_;
  std::vector<Vector> ways_;  ///< B_j
  std::vector<Bounds> numbers_;
  Vector squares_;  ///< of a ball: of the most that each number is in it
};

}  // namespace stickslip_check
