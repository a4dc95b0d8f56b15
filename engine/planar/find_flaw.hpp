// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts on one grasp in the plane are judged here in memory.
#pragma once

#include <optional>
#include <string>

#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// Returns the first node at which a rule of certificate/FORMAT.md, section 4, fails; nothing
/// for a refutation that holds. O(nodes * m * rays) rational operations.
std::optional<std::string> find_flaw(const Problem& problem, const Trees& refutation);

/// Throws ContractError if the verdict's evidence does not hold. This is for callers who hold a
/// verdict in memory; the checkers in certificate/ are the judges for everybody else. It runs
/// on every verdict of the engines in the `dev` preset (STICKSLIP_VALIDATE).
void validate(const Problem& problem, const Verdict& verdict);

}  // namespace stickslip
