// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The naive twin of the library's verification: the conditions of linear_program.hpp, one
/// rational operation after the other.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {

/// True when the evidence of `result` proves it.
::testing::AssertionResult check(const LinearProgram& program, const LpResult& result);

enum class Status { kOptimal, kInfeasible, kUnbounded };
Status status(const LpResult& result);
std::ostream& operator<<(std::ostream& out, Status status);

/// Requires an Optimal.
const Rational& value(const LpResult& result);

/// The program in readable form, for messages.
std::string print(const LinearProgram& program);

}  // namespace stickslip::lp_test
