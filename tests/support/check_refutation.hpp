// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Judges a refutation by the rules of certificate/FORMAT.md, section 4, in two ways at once:
/// Region keeps the cones, naive_region.hpp applies the rules, and the two must agree at every
/// node.
#pragma once

#include <optional>
#include <string>

#include "stickslip/engine/verdict.hpp"

namespace stickslip::test {

/// Whose rays the rules are applied to.
enum class RaysFrom {
  kRegion,
  kBruteForce,  ///< slow; proves the verdict without Cone
};

/// The rule that fails first, and at which node; nothing if the refutation proves that there is
/// no equilibrium. Also reports where Region and its twin disagree.
std::optional<std::string> check_refutation(const Problem& problem, const Trees& refutation,
                                            RaysFrom rays_from = RaysFrom::kRegion);

/// One node a line, as in a certificate.
std::string to_text(const Trees& refutation);

}  // namespace stickslip::test
