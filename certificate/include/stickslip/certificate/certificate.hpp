// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Writers of certificates in the format of certificate/FORMAT.md, and of questions for other
/// solvers. The checkers that read certificates share no code with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/earlier/robustness.hpp"
#include "stickslip/earlier/statics.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/measures/margin.hpp"
#include "stickslip/measures/region_proof.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

/// Returns the certificate of a verdict, ending in a newline; one node a line. `producer` is a
/// remark without meaning, `bits` is that of BoxDecision. Throws ContractError unless the
/// verdict is Stable or Unstable.
std::string certificate_text(const Question& question, const Verdict& verdict,
                             const std::string& producer, unsigned bits = kDefaultBits);

/// Returns the certificate of an answer; nothing if its verdict has none: undecided or fragile.
std::optional<std::string> certificate_of(const Answer& answer);

/// Returns why stickslip-check does not accept the certificate as a proof of a verdict about
/// the question, in its words; nothing if it accepts. Requires that the question is no margin.
std::optional<std::string> refusal_of(const Question& question, const std::string& certificate);

/// Returns the producer of a certificate: "stickslip 0.1.0, engine space".
std::string producer_of(const std::string& engine);

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

/// Returns the certificate of the bounds of PCR or PGR of the question's grasp (FORMAT.md,
/// section 18). Preloads, the normal law and the bound of motions play no part. Throws
/// ContractError unless the question is about one load of one grasp.
std::string robustness_certificate_text(const Question& question, RobustnessKind kind,
                                        const RobustnessOptions& options,
                                        const Robustness& found, const std::string& producer);

/// A question of statics beside its grasp and load (FORMAT.md, section 16).
struct StaticsAsked {
  Rational friction_factor{1};            ///< the factor of all friction
  std::vector<RationalRow> directions{};  ///< one, of a margin, or two, of a region
};

/// \{ Return the certificate of one load's statics, or of which loads of a line or plane may
/// stand. The question's bound of motions plays no part. Throw ContractError for Undecided, and
/// unless the question is about one grasp.
std::string statics_certificate_text(const Question& question, const StaticsAsked& asked,
                                     const LoadClass& found, const std::string& producer);
std::string statics_certificate_text(const Question& question, const StaticsAsked& asked,
                                     const StandingLoads& found, const std::string& producer);
/// \}

/// Returns the whole question as an SMT-LIB 2 problem for solvers such as Z3 and cvc5. It is a
/// complete script: declarations, the conditions of problem.hpp with their disjunctions,
/// (check-sat). `sat` means stable, `unsat` unstable. In the plane the logic is QF_LRA, with
/// variables dx, dy, dr and, per contact i, a_i and b_i (force coefficients of the contact's
/// own normal and tangent). In space, and if a preloaded normal has an irrational length, it is
/// QF_NRA with Coulomb's cone as it is: a_i, friction fx_i, fy_i, fz_i across the normal, and
/// t_i, friction over slip. Throws InputError for a box of more than one grasp.
std::string smtlib_text(const Question& question);

}  // namespace stickslip
