// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs about a box as a whole or cut into parts, without a search for counterexamples.
#pragma once

#include <optional>

#include "stickslip/box/box_verdict.hpp"

namespace stickslip::box_detail {

/// Stable or unstable throughout, or undecided; never fragile. Irrational lengths are enclosed
/// as the options say.
BoxDecision prove_box(const GraspBox& box, NormalLaw law, const BoxOptions& options,
                      std::size_t most_parts);

/// Whether all grasps of the box are stable, or none; nothing if neither is proved.
std::optional<bool> throughout(const BoxDecision& decision);

}  // namespace stickslip::box_detail
