// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Takes contacts to linear algebra: the rows N and T of each contact and the coefficients of
/// its normal law. The rows are the columns of the paper's grasp map G (Eq. 1), and the law is
/// its Eq. 4 with preload.
///
/// Force coefficients (a, b) stand for the force a n + b t, for a normal n of any length L, so
/// that the magnitudes are c_n = a L and c_t = b L. Cones and the signs of motion do not see L;
/// the normal law becomes a = P/L - (k/L^2) N.d. L^2 is rational, so only a preloaded contact
/// needs a rational L.
#pragma once

#include <vector>

#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// The rows and the coefficients of the laws of one contact, which are all that the model needs
/// of it.
struct ContactRow {
  /// N = (n_x, n_y, p_x n_y - p_y n_x); power(N, d) = normal displacement times L
  Wrench normal;
  Wrench tangent;      ///< T = (t_x, t_y, p_x t_y - p_y t_x); power(T, d) = slip times L
  Rational friction;   ///< mu
  Rational preload;    ///< P / L
  Rational stiffness;  ///< k / L^2

  /// Returns v(d) = preload - stiffness N.d, the coefficient of the normal force while the
  /// contact is closed.
  Rational normal_coefficient(const Twist& d) const {
    return preload - stiffness * power(normal, d);
  }
};

/// \{ Returns N, or T, of one contact. It needs no length of the normal, so that it serves
/// irrational L as well.
Wrench normal_row(const Contact& contact);
Wrench tangent_row(const Contact& contact);
/// \}

/// Returns the rows of all contacts, in their order. Throws InputError ("contacts[i].normal")
/// when a preloaded contact has a normal of irrational length; the remedy is snapping.
std::vector<ContactRow> contact_rows(const Grasp& grasp);

}  // namespace stickslip
