// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Writers of certificates in the format of certificate/FORMAT.md, and of questions for other
/// solvers. The checkers that read certificates share no code with this.
#pragma once

#include <string>

#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/engine/verdict.hpp"
#include "stickslip/measures/margin.hpp"
#include "stickslip/measures/region_proof.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

/// Returns the certificate of a verdict, ending in a newline; one node a line. `producer` is a
/// remark without meaning, `bits` is that of BoxDecision. Throws ContractError unless the
/// verdict is Stable or Unstable.
std::string certificate_text(const Question& question, const Verdict& verdict,
                             const std::string& producer, unsigned bits = kDefaultBits);

/// \{ Return the certificate of the margin of problem_of(question), by segments, and of one by
/// claims (FORMAT.md, section 5).
std::string margin_certificate_text(const Question& question, const Margin& margin,
                                    const std::string& producer);
std::string margin_certificate_text(const Question& question, const SpatialMargin& margin,
                                    const std::string& producer);
/// \}

/// Returns the certificate of the resistible wrenches of a plane (FORMAT.md, section 12). The
/// wrench of the question plays no part.
std::string region_certificate_text(const Question& question, const WrenchPlane& plane,
                                    const RegionProof& proof, const std::string& producer);

/// Returns the certificate of the class of a load (FORMAT.md, section 13). Throws ContractError
/// for Undecided, and unless the question is about one load of one grasp.
std::string class_certificate_text(const Question& question, const Inertia& inertia,
                                   const RigidVerdict& verdict, const std::string& producer);

/// Returns the whole question as an SMT-LIB 2 problem for solvers such as Z3 and cvc5. It is a
/// complete script: declarations, the conditions of problem.hpp with their disjunctions,
/// (check-sat). `sat` means stable, `unsat` unstable. In the plane the logic is QF_LRA, with
/// variables dx, dy, dr and, per contact i, a_i and b_i (force coefficients of the contact's
/// own normal and tangent). In space, and if a preloaded normal has an irrational length, it is
/// QF_NRA with Coulomb's cone as it is: a_i, friction fx_i, fy_i, fz_i across the normal, and
/// t_i, friction over slip. Throws InputError for a box of more than one grasp.
std::string smtlib_text(const Question& question);

}  // namespace stickslip
