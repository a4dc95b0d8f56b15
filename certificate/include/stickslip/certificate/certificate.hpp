// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Writing certificates in the format of certificate/FORMAT.md. The checkers that read them
/// share no code with this.
#pragma once

#include <string>

#include "stickslip/equilibrium/margin.hpp"
#include "stickslip/equilibrium/question.hpp"
#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip {

/// The certificate of a verdict, ending in a newline; one node a line. `producer` is a remark
/// without meaning. Throws ContractError for Undecided, which proves nothing, and InputError
/// for a question whose normals were replaced.
std::string certificate_text(const Question& question, const Verdict& verdict,
                             const std::string& producer);

/// The certificate of the margin of problem_of(question) (FORMAT.md, section 5).
std::string margin_certificate_text(const Question& question, const Margin& margin,
                                    const std::string& producer);

}  // namespace stickslip
