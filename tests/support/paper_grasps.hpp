// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The grasps of Haas-Heger et al., RSS 2018. mu = 1/2 and k = 1 throughout.
#pragma once

#include "stickslip/core/grasp.hpp"
#include "stickslip/core/number.hpp"

namespace stickslip::test {

/// A number as the paper prints it.
inline Rational q(const char* text) {
  return parse_rational(text);
}

/// Contacts at (-1, 0), (0, -1), (1, 0) with normals towards the origin.
Grasp fig1_grasp(const Rational& preload);

/// Contacts at (-1, 1), (-1, -1), (1, -1), (1, 1); normals (1, 0), (1, 0), (-1, 0), (-1, 0).
Grasp fig4_grasp(const Rational& preload);

}  // namespace stickslip::test
