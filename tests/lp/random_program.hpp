// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Random programs of every shape, with the degeneracies that occur in practice: duplicate and
/// zero rows, redundant equations, zero right-hand sides, coefficients in {-1, 0, 1}.
#pragma once

#include <random>

#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {

/// Uniform in low..high, the same on every platform (unlike std::uniform_int_distribution).
int draw(std::mt19937& random, int low, int high);

/// 1..max_variables variables, 1..max_rows rows.
LinearProgram random_program(std::mt19937& random, int max_variables, int max_rows);

}  // namespace stickslip::lp_test
