// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The judgement of another program's answer, as `crosscheck --json` prints it.
#pragma once

#include "stickslip/core/number_text.hpp"
#include "stickslip/measures/claim.hpp"

namespace stickslip {

/// Returns the class of the claim, what its solution misses, and how far it is from a
/// threshold, before finished().
Json claim_json(const Question& question, const Claim& claim, const ClaimReport& report);

}  // namespace stickslip
