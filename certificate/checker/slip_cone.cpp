// SPDX-License-Identifier: MIT
#include "slip_cone.hpp"

#include <utility>

namespace stickslip_check {
namespace {

bool is_zero(const Form& s) {
  return sign_of_dot(s, s) == 0;
}

}  // namespace

SlipCone::SlipCone(const Vector& normal) {
  // Where n_j is not 0, coordinate j of s follows from the other two.
  std::size_t j = 0;
  while (normal[j] == 0) ++j;
  one_ = (j + 1) % 3;
  other_ = (j + 2) % 3;
}

/// 1 if b is at the left of a, less than half a turn away; -1 if at the right; 0 if on its
/// line.
int SlipCone::turn(const Form& a, const Form& b) const {
  return cmp(Integer(a[one_] * b[other_]), Integer(a[other_] * b[one_]));
}

bool SlipCone::contains(const Form& s) const {
  switch (shape_) {
    case Shape::kPoint:
      return is_zero(s);
    case Shape::kRay:
      return turn(first_, s) == 0 && sign_of_dot(first_, s) >= 0;
    case Shape::kLine:
      return turn(first_, s) == 0;
    case Shape::kWedge:
      return turn(first_, s) >= 0 && turn(s, last_) >= 0;
    case Shape::kHalf:
      return turn(first_, s) >= 0;
    default:
      return true;
  }
}

void SlipCone::add(const Form& s) {
  if (contains(s)) return;
  const int first = shape_ == Shape::kPoint ? 0 : turn(first_, s);
  const int last = shape_ == Shape::kPoint ? 0 : turn(s, last_);
  switch (shape_) {
    case Shape::kPoint:
      shape_ = Shape::kRay;
      first_ = last_ = s;
      break;
    case Shape::kRay:
      shape_ = first == 0 ? Shape::kLine : Shape::kWedge;
      (first < 0 ? first_ : last_) = s;
      break;
    case Shape::kLine:
      shape_ = Shape::kHalf;
      if (first < 0) std::swap(first_, last_);
      break;
    case Shape::kWedge:
      if (first < 0 && last < 0) {
        shape_ = Shape::kPlane;
      } else {
        if (first == 0 || last == 0) shape_ = Shape::kHalf;
        (first < 0 ? first_ : last_) = s;
      }
      break;
    default:
      shape_ = Shape::kPlane;
  }
}

std::vector<Form> SlipCone::sides() const {
  if (shape_ == Shape::kPoint || shape_ == Shape::kPlane) return {};
  return {first_, last_};
}

}  // namespace stickslip_check
