// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads the several bodies of a grasp file of version 3.
#pragma once

#include <vector>

#include "intervals.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/mechanism.hpp"

namespace stickslip::core_detail {

/// Returns the mechanism that "bodies" and "joints" describe, checked. Throws InputError.
Mechanism read_mechanism(const JsonNode& root, bool in_space);

/// Returns the springs: "ratchets", then the springs of those "joints" that have one, and then
/// "tendons".
std::vector<Spring> read_springs(const JsonNode& root, const Mechanism& mechanism,
                                 IntervalReader& read);

}  // namespace stickslip::core_detail
