// SPDX-License-Identifier: MIT
/// \file
/// The cone C_i of FORMAT.md §7: all sums of slips of one contact, which lie in the plane
/// n.s = 0, with multiples >= 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "number.hpp"

namespace stickslip_check {

class SlipCone {
 public:
  /// {0}, for slips across this normal.
  explicit SlipCone(const Vector& normal);

  /// The cone of this one and of s.
  void add(const Form& s);
  bool contains(const Form& s) const;
  /// On which every unit vector of the cone lies, or between which: none of {0} and of the
  /// whole plane.
  std::vector<Form> sides() const;

 private:
  /// Vectors of a plane are told apart by two coordinates.
  int turn(const Form& a, const Form& b) const;

  /// All between `first_` and `last_`, at its left: a wedge of less than half of the plane, or
  /// a half.
  enum class Shape : std::int8_t { kPoint, kRay, kLine, kWedge, kHalf, kPlane };
  Shape shape_ = Shape::kPoint;
  Form first_;
  Form last_;
  std::size_t one_;  ///< the two coordinates
  std::size_t other_;
};

}  // namespace stickslip_check
