// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The verdict of an SMT solver. The model is written out from the contacts of a grasp alone,
/// in the words of physics, and all arithmetic is left to the solver; nothing is shared with
/// the code under test but the grasp.
#pragma once

#include <string>
#include <vector>

#include "random_grasps.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip::test {

/// Whose conditions: the passive model's, or an earlier method's.
enum class Model {
  kPassive,
  kConesAlone,     ///< without maximum dissipation
  kWeak,           ///< any forces in the cones
  kFrictionless,   ///< any normal forces
  kAccelerates,    ///< rigid contacts, unit mass and inertia about the origin, nonzero
                   ///< acceleration (x, y, r)
  kLinearSprings,  ///< along normals and tangents
  kThreeStates     ///< such springs, or a normal spring alone, or released
};

/// The question as SMT-LIB 2 (QF_LRA), satisfiable iff the model has a solution: declarations
/// and assertions, without check-sat.
std::string smt_assertions(const LoadCase& load_case, Model model = Model::kPassive);

/// "stable" if the model has a solution, "unstable" if it has none, or what else z3 says, for
/// each. Throws std::runtime_error when the program is missing or does not give an answer to
/// each.
std::vector<std::string> ask_z3(const std::vector<LoadCase>& load_cases,
                                Model model = Model::kPassive);

/// Some multiples of a margin's family.
struct FamilyCase {
  Question margin;
  MultipleRange range;
};

/// For each "stable" if the passive model has a solution for some multiple in the range,
/// "unstable" if it has none for any: the multiple is one more unknown of the solver.
std::vector<std::string> ask_z3(const std::vector<FamilyCase>& families);

}  // namespace stickslip::test
