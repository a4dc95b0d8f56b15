// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// First-order form closure: do the contacts, without friction, leave the object no motion?
///
/// A motion d is free when no contact is penetrated to first order: N_i.d >= 0 for all i. The
/// grasp has form closure iff only d = 0 is free. That holds iff the N_i span Q^D (D = 3 in the
/// plane, 6 in space) and some multipliers lambda_i > 0 give sum lambda_i N_i = 0:
///
/// - if so, a free d has 0 = sum lambda_i N_i.d with no negative term, so N_i.d = 0 for all i,
///   and d = 0 since the N_i span;
/// - if no such multipliers exist, Farkas' lemma gives d with all N_i.d >= 0 and their sum > 0;
///   if the N_i do not span, some d != 0 has N_i.d = 0 for all i.
///
/// Form closure is a property of the grasp alone: load, preload, stiffness and friction play no
/// part.
///
/// Source: Liu, "Qualitative test and force optimization of 3-D frictional form-closure grasps
/// using linear programming", IEEE Trans. Robotics and Automation 15(1), 1999; Lynch and Park,
/// Modern Robotics, 2017, Section 12.1.7. Haas-Heger et al., RSS 2018, Section II.
#pragma once

#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// Evidence for form closure.
struct FormClosure {
  std::vector<Rational> multipliers;  ///< lambda_i >= 1, by ContactId, for N_i as in the rows
  std::vector<ContactId> spanning;    ///< D contacts whose N are linearly independent
};

/// Evidence against form closure: d != 0 with N_i.d >= 0 for all i.
struct FreeMotion {
  Row motion;  ///< coprime integers
};

/// Returns evidence for or against form closure by the N_i, which have as many coordinates as
/// motions. It is checked by substitution first. One linear program with D rows and a variable
/// per contact.
std::variant<FormClosure, FreeMotion> form_closure(const std::vector<RationalRow>& normals,
                                                   std::size_t motions);
/// \{ The same for a grasp in the plane, and for one in space without uncertain numbers.
std::variant<FormClosure, FreeMotion> form_closure(const Problem& problem);
std::variant<FormClosure, FreeMotion> form_closure(const GraspBox& grasp);
/// \}

}  // namespace stickslip
