// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A motion and forces that are nearly an equilibrium, in doubles. They only propose.
#pragma once

#include <vector>

#include "stickslip/engine/law.hpp"

namespace stickslip {

/// A motion at which forces nearly balance the load, in the law's units. It comes from a
/// relaxation, divided by its height h, or from Newton's method.
struct NearEquilibrium {
  Reals motion;                   ///< d
  std::vector<double> normal;     ///< a, by contact
  std::vector<Double3> friction;  ///< f by contact, with as many coordinates as a slip
  std::vector<char> sticks;       ///< whether the slip of a contact with friction is nearly 0
  double multiple = 0;            ///< the multiple l of a relaxation
};

}  // namespace stickslip
