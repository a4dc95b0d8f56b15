// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Checks the evidence of an LP answer against the program as it was given, by substitution in
/// exact arithmetic. The conditions, and why they suffice, are in linear_program.hpp. The
/// checks share no code with the solver, except the reading of a GMP number that fits a machine
/// word.
///
/// They take O(mn) integer multiplications, for vectors with m and n entries.
#pragma once

#include <cstddef>

#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

/// The conditions that linear_program.hpp states.
enum class LpCondition {
  kLength,          ///< one entry per variable, or per row
  kPointSign,       ///< x_j >= 0 for a variable >= 0
  kPointRow,        ///< the point satisfies the row
  kMultiplierSign,  ///< y is admissible
  kCombination,     ///< sign of c - yA (Optimal), of -yA (Infeasible), per variable
  kPointValue,      ///< c.x = value
  kDualValue,       ///< y.b = value
  kContradiction,   ///< y.b > 0
  kRaySign,         ///< d_j >= 0 for a variable >= 0
  kRayRow,          ///< the ray is a recession direction of the row
  kRayDescent,      ///< c.d < 0
};

/// The result of a check. It converts to true when the evidence holds; otherwise it names the
/// first condition that fails and the index of the row or variable (0 where neither applies).
struct Verification {
  bool holds = true;  ///< whether every condition holds
  /// The first that fails; without meaning if all hold.
  LpCondition failed = LpCondition::kLength;
  std::size_t index = 0;  ///< the row or variable where it fails

  /// Returns whether the evidence holds.
  explicit operator bool() const { return holds; }
};

/// \{ \brief Returns whether the evidence proves what its type says of the program. Evidence of
/// the wrong length fails by kLength.
Verification verify(const LinearProgram& program, const Optimal& evidence);
Verification verify(const LinearProgram& program, const Infeasible& evidence);
Verification verify(const LinearProgram& program, const Unbounded& evidence);
Verification verify(const LinearProgram& program, const LpResult& result);
/// \}

}  // namespace stickslip
