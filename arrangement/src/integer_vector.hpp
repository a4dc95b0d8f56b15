// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Products of integer vectors of length 3, for the sources of this module.
#pragma once

#include "stickslip/arrangement/great_circles.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip {

inline IntegerVector3 cross(const IntegerVector3& a, const IntegerVector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace stickslip
