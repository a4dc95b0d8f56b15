// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The verdict of an SMT solver. The model is written out from the contacts of a grasp alone,
/// in the words of physics, and all arithmetic is left to the solver; nothing is shared with
/// the code under test but the grasp.
#pragma once

#include <string>
#include <vector>

#include "random_grasps.hpp"

namespace stickslip::test {

/// The question as SMT-LIB 2 (QF_LRA), satisfiable iff the grasp is stable: declarations and
/// assertions, without check-sat.
std::string smt_assertions(const LoadCase& load_case);

/// "stable", "unstable", or what else z3 says, for each. Throws std::runtime_error when the
/// program is missing or does not give an answer to each.
std::vector<std::string> ask_z3(const std::vector<LoadCase>& load_cases);

}  // namespace stickslip::test
