// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// From contacts to linear algebra: the rows N and T of each contact and the coefficients of
/// its normal law. The rows are the columns of the paper's grasp map G (Eq. 1), the law is its
/// Eq. 4 with preload.
///
/// With a normal n of any length L, force coefficients (a, b) stand for the force
/// a n + b t, so that the magnitudes are c_n = a L and c_t = b L. Cones and the signs of
/// motion do not see L; the normal law becomes a = P/L - (k/L^2) N.d. L^2 is rational,
/// so only a preloaded contact needs a rational L.
#pragma once

#include <vector>

#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// What the model needs of one contact: its rows and the coefficients of its laws.
struct ContactRow {
  /// N = (n_x, n_y, p_x n_y - p_y n_x); power(N, d) = normal displacement times L
  Wrench normal;
  Wrench tangent;      ///< T = (t_x, t_y, p_x t_y - p_y t_x); power(T, d) = slip times L
  Rational friction;   ///< mu
  Rational preload;    ///< P / L
  Rational stiffness;  ///< k / L^2

  /// v(d) = preload - stiffness N.d: the coefficient of the normal force while closed.
  Rational normal_coefficient(const Twist& d) const {
    return preload - stiffness * power(normal, d);
  }
};

/// \{ N and T of one contact; needs no length, so it serves irrational L as well.
Wrench normal_row(const Contact& contact);
Wrench tangent_row(const Contact& contact);
/// \}

/// All rows, in the order of the contacts. Throws InputError ("contacts[i].normal") when a
/// preloaded contact has a normal of irrational length; the remedy is snapping.
std::vector<ContactRow> contact_rows(const Grasp& grasp);

}  // namespace stickslip
