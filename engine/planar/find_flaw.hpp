// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts on one grasp in the plane judged in memory.
#pragma once

#include <optional>
#include <string>

#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// The first node at which a rule of certificate/FORMAT.md, section 4, fails; nothing for a
/// refutation that holds. O(nodes * m * rays) rational operations.
std::optional<std::string> find_flaw(const Problem& problem, const Trees& refutation);

/// For callers who hold a verdict in memory; the checkers in certificate/ are the judges for
/// everybody else. Runs on every verdict of the engines in the `dev` preset
/// (STICKSLIP_VALIDATE). Throws ContractError if the verdict's evidence does not hold.
void validate(const Problem& problem, const Verdict& verdict);

}  // namespace stickslip
