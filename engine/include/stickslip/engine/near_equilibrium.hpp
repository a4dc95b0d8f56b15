// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What is nearly an equilibrium, in doubles: proposals alone.
#pragma once

#include <vector>

#include "stickslip/engine/law.hpp"

namespace stickslip {

/// A motion at which forces nearly balance the load, in the law's units: of a relaxation over
/// its height, or of Newton's method.
struct NearEquilibrium {
  Reals motion;                   ///< d
  std::vector<double> normal;     ///< a by contact
  std::vector<Double3> friction;  ///< f by contact: as a slip has coordinates
  std::vector<char> sticks;       ///< whether the slip is nearly 0, of contacts that rub
  double multiple = 0;            ///< l, of a relaxation
};

}  // namespace stickslip
