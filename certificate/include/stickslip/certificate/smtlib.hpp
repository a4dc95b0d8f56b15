// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The whole question as an SMT-LIB 2 problem in the logic QF_LRA, for solvers such as Z3 and
/// cvc5.
#pragma once

#include <string>

#include "stickslip/equilibrium/question.hpp"

namespace stickslip {

/// A complete script: declarations, the conditions of problem.hpp with their disjunctions,
/// (check-sat). `sat` means stable, `unsat` unstable. Variables dx, dy, dr and, per contact i,
/// a_i and b_i (force coefficients of the contact's own normal and tangent). Throws InputError
/// when a preloaded contact has a normal of irrational length.
std::string smtlib_text(const Question& question);

}  // namespace stickslip
